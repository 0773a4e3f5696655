// SPDX-License-Identifier: BSD-3-Clause
#include "progress_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <vector>

namespace tolman::progress {

namespace {

std::string count(std::int64_t number, std::string_view what) {
  return std::to_string(number) + " " + std::string(what) + (number == 1 ? "" : "s");
}

/// "3.7 s"; from one minute "1:04 min"; from one hour "1:02 h".
std::string duration(double seconds) {
  const double known = std::clamp(seconds, 0.0, 1e9);
  char text[48];
  if (std::llround(10 * known) < 600) {
    std::snprintf(text, sizeof text, "%.1f s", 0.1 * static_cast<double>(std::llround(10 * known)));
    return text;
  }
  const bool hours = std::llround(known) >= 3600;
  const auto units = static_cast<int>(std::llround(hours ? known / 60 : known));
  std::snprintf(text, sizeof text, "%d:%02d %s", units / 60, units % 60, hours ? "h" : "min");
  return text;
}

double perSecond(std::int64_t frames, const ProgressState& s) {
  return s.seconds > 0 ? static_cast<double>(frames) / s.seconds : 0;
}

std::int64_t processed(const ProgressState& s) { return s.frames - s.left_out; }

std::string speed(const ProgressState& s) {
  char text[48];
  const double fps = perSecond(processed(s), s);
  std::snprintf(text, sizeof text, fps < 100 ? "%.1f frames/s" : "%.0f frames/s", fps);
  return text;
}

bool hasTimeLeft(const ProgressState& s) {
  return s.total >= s.frames && perSecond(s.frames, s) > 0;
}

std::string timeLeft(const ProgressState& s) {
  return duration(static_cast<double>(s.total - s.frames) / perSecond(s.frames, s)) + " left";
}

std::int64_t percent(const ProgressState& s) {
  return std::clamp<std::int64_t>(s.frames * 100 / std::max<std::int64_t>(s.total, 1), 0, 100);
}

/// The parts after the bar, the most important first.
std::vector<std::string> barParts(const ProgressState& s) {
  std::vector<std::string> parts;
  if (s.total > 0) {
    parts.push_back(std::to_string(percent(s)) + " %");
    parts.push_back(std::to_string(s.frames) + "/" + std::to_string(s.total));
  } else {
    parts.push_back(count(s.frames, "frame"));
  }
  parts.push_back(speed(s));
  if (hasTimeLeft(s)) parts.push_back(timeLeft(s));
  parts.push_back(count(s.templates, "template"));
  parts.push_back(count(s.experiences, "experience"));
  parts.push_back(count(s.loop_decisions, "loop decision"));
  return parts;
}

/// "[====>     ]" with `cells` cells.
std::string bar(const ProgressState& s, std::size_t cells) {
  const auto done = static_cast<std::size_t>(percent(s)) * cells / 100;
  std::string filled(done, '=');
  if (done > 0 && done < cells) filled.back() = '>';
  return "[" + filled + std::string(cells - done, ' ') + "]";
}

std::string counts(const ProgressState& s) {
  return count(s.templates, "template") + ", " + count(s.experiences, "experience") + ", ";
}

}  // namespace

std::string barLine(const ProgressState& state, int width) {
  constexpr std::size_t kMinCells = 10;
  constexpr std::size_t kMaxCells = 40;
  const auto room = static_cast<std::size_t>(std::max(width - 1, 0));
  const bool has_bar = state.total > 0 && room >= kMinCells + 8;
  const std::size_t least_bar = has_bar ? kMinCells + 2 : 0;
  std::string text;
  for (const std::string& part : barParts(state)) {
    if (least_bar + text.size() + 2 + part.size() > room) break;
    text += (text.empty() ? " " : "  ") + part;
  }
  if (!has_bar) return text.empty() ? text : text.substr(1);
  const std::size_t cells = std::min(room - 2 - text.size(), kMaxCells);
  return bar(state, cells) + text;
}

std::string coloured(std::string bar_line) {
  const std::size_t end = bar_line.find_first_not_of("=>", 1);
  if (!bar_line.starts_with('[') || end == std::string::npos || end == 1) return bar_line;
  return bar_line.insert(end, "\x1b[0m").insert(1, "\x1b[32m");
}

std::string plainLine(const ProgressState& state) {
  std::string text = "frame " + std::to_string(state.frames);
  if (state.total > 0) {
    text += " of " + std::to_string(state.total) + " (" + std::to_string(percent(state)) + " %)";
  }
  text += ", " + speed(state);
  if (hasTimeLeft(state)) text += ", " + timeLeft(state);
  return text + ", " + counts(state) + count(state.loop_decisions, "loop decision");
}

std::string summaryLine(const ProgressState& state) {
  const std::string frames = count(processed(state), "frame");
  const std::string all = state.left_out == 0 ? frames
                                              : frames + " processed and " +
                                                    std::to_string(state.left_out) + " left out";
  return all + " in " + duration(state.seconds) + ", " + speed(state) + ", " + counts(state) +
         count(state.loop_links, "loop link");
}

}  // namespace tolman::progress
