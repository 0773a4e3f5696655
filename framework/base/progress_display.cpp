// SPDX-License-Identifier: BSD-3-Clause
#include "base/progress_display.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace tolman {
namespace {

constexpr std::int64_t kRedrawNs = 100'000'000;

template <class... Values>
std::string formatted(const char* format, Values... values) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

double perSecond(std::int64_t frames, double seconds) {
  return seconds > 0 ? static_cast<double>(frames) / seconds : 0;
}

std::int64_t tenthsOf(const FrameCount& count) {
  return count.total > 0 ? 10 * count.done / count.total : 0;
}

}  // namespace

std::string durationText(double seconds) {
  const double known = std::isfinite(seconds) ? std::clamp(seconds, 0.0, 1e9) : 0.0;
  const long long tenths = std::llround(10 * known);
  if (tenths < 600) return formatted("%lld.%lld s", tenths / 10, tenths % 10);
  const bool hours = std::llround(known) >= 3600;
  const long long units = std::llround(hours ? known / 60 : known);
  return formatted("%lld:%02lld %s", units / 60, units % 60, hours ? "h" : "min");
}

std::string speedText(const FrameCount& count) {
  const double rate = perSecond(count.done - count.left_out, count.seconds);
  return formatted(rate < 100 ? "%.1f frames/s" : "%.0f frames/s", rate);
}

std::string frameText(const FrameCount& count) {
  std::string text = "frame " + std::to_string(count.done);
  if (count.total > 0) {
    const std::int64_t percent = std::min<std::int64_t>(100 * count.done / count.total, 100);
    text += " of " + std::to_string(count.total) + " (" + std::to_string(percent) + " %)";
  }
  text += ", " + speedText(count);
  const double rate = perSecond(count.done, count.seconds);
  if (count.total < count.done || rate <= 0) return text;
  return text + ", " + durationText(static_cast<double>(count.total - count.done) / rate) + " left";
}

int terminalWidth() {
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

void StatusLine::show(const std::string& line) {
  // The last column is left free, where terminals wrap.
  redraw(line.substr(0, static_cast<std::size_t>(std::max(width_() - 1, 0))));
}

void StatusLine::add(const std::string& line) {
  erase();
  out_ << line + "\n" << std::flush;
}

void StatusLine::erase() {
  if (drawn_ > 0) redraw("");
}

void StatusLine::keep() {
  if (drawn_ > 0) out_ << '\n' << std::flush;
  drawn_ = 0;
}

void StatusLine::redraw(const std::string& line) {
  // Blanks erase the rest of the old line; unlike control codes they work on every terminal. Not
  // more than the window has columns, which may have been made smaller.
  const std::size_t before = std::min(drawn_, static_cast<std::size_t>(std::max(width_() - 1, 0)));
  const std::string wipe(before > line.size() ? before - line.size() : 0, ' ');
  // One write, so that no log line of another thread comes in between.
  out_ << "\r" + line + wipe + (line.empty() ? "\r" : "") << std::flush;
  drawn_ = line.size();
}

void ProgressDisplay::begin(std::int64_t now_ns) {
  begin_ns_ = now_ns;
  shown_ns_ = interactive_ ? now_ns - kRedrawNs : now_ns;  // the first frame is shown at once
  shown_tenths_ = 0;
  line_.erase();
}

bool ProgressDisplay::isDue(const FrameCount& count, std::int64_t now_ns) const {
  constexpr std::int64_t kSilenceNs = 5'000'000'000;
  if (interactive_) return now_ns - shown_ns_ >= kRedrawNs;
  return tenthsOf(count) > shown_tenths_ ||
         now_ns - shown_ns_ >= std::max(kSilenceNs, (now_ns - begin_ns_) / 10);
}

void ProgressDisplay::show(const std::string& text, const FrameCount& count, std::int64_t now_ns) {
  interactive_ ? line_.show(text) : line_.add(text);
  shown_ns_ = now_ns;
  shown_tenths_ = tenthsOf(count);
}

}  // namespace tolman
