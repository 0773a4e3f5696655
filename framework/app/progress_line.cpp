// SPDX-License-Identifier: BSD-3-Clause
#include "app/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "app/duration_text.hpp"
#include "engine/terminal.hpp"

namespace tolman::app {
namespace {

double rate(const FrameCount& c) {
  return c.seconds > 0 ? static_cast<double>(c.done) / c.seconds : 0;
}

std::int64_t percent(const FrameCount& c) {
  return std::clamp<std::int64_t>(100 * c.done / std::max<std::int64_t>(c.total, 1), 0, 100);
}

/// "6.0 s left", or nothing where that is not known.
std::string timeLeft(const FrameCount& c) {
  if (c.total < c.done || rate(c) <= 0) return {};
  return durationText(static_cast<double>(c.total - c.done) / rate(c)) + " left";
}

}  // namespace

std::string barText(const FrameCount& count, int width) {
  std::string text;
  if (count.total > 0) {
    constexpr std::size_t kCells = 20;
    const auto done = static_cast<std::size_t>(percent(count)) * kCells / 100;
    std::string filled(done, '=');
    if (done > 0 && done < kCells) filled.back() = '>';
    text = fmt::format("[{:<{}}] {} %  {}/{}", filled, kCells, percent(count), count.done,
                       count.total);
  } else {
    text = fmt::format("{} frames", count.done);
  }
  text += fmt::format("  {:.1f} frames/s", rate(count));
  const std::string left = timeLeft(count);
  if (!left.empty()) text += "  " + left;
  return text.substr(0, static_cast<std::size_t>(std::max(width - 1, 0)));
}

std::string plainText(const FrameCount& count) {
  std::string text = fmt::format("frame {}", count.done);
  if (count.total > 0) text += fmt::format(" of {} ({} %)", count.total, percent(count));
  text += fmt::format(", {:.1f} frames/s", rate(count));
  const std::string left = timeLeft(count);
  return left.empty() ? text : text + ", " + left;
}

Terminal terminalOf(const Invocation& invocation) {
  return {isatty(STDERR_FILENO) == 1 && !invocation.quiet, invocation.quiet};
}

std::int64_t framesToCome(std::int64_t wanted, std::int64_t known) {
  return wanted < 0 || known < 0 ? std::max(wanted, known) : std::min(wanted, known);
}

ProgressLine::ProgressLine(std::ostream& out, const Clock& clock, Terminal terminal,
                           std::int64_t total)
    : out_(out),
      clock_(clock),
      terminal_(terminal),
      begin_ns_(clock.steadyNs()),
      shown_ns_(begin_ns_) {
  count_.total = total;
}

ProgressLine::~ProgressLine() {
  if (drawn_ > 0) redraw("");
}

void ProgressLine::step() {
  constexpr std::int64_t kRedrawNs = 100'000'000;     // ten times a second
  constexpr std::int64_t kSilenceNs = 5'000'000'000;  // longest time without a line
  if (terminal_.quiet) return;
  const std::lock_guard lock(mutex_);
  ++count_.done;
  const std::int64_t now = clock_.steadyNs();
  count_.seconds = static_cast<double>(now - begin_ns_) * 1e-9;
  const std::int64_t tenths = count_.total > 0 ? percent(count_) / 10 : 0;
  const bool due = terminal_.interactive ? now - shown_ns_ >= kRedrawNs
                                         : tenths > shown_tenths_ || now - shown_ns_ >= kSilenceNs;
  if (!due) return;
  if (terminal_.interactive) {
    redraw(barText(count_, run::terminalWidth(STDERR_FILENO)));
  } else {
    out_ << plainText(count_) << '\n' << std::flush;
  }
  shown_ns_ = now;
  shown_tenths_ = tenths;
}

void ProgressLine::redraw(const std::string& line) {
  const std::string wipe(drawn_ > line.size() ? drawn_ - line.size() : 0, ' ');
  // One write, so that no log line of another thread comes in between.
  out_ << "\r" + line + wipe + (line.empty() ? "\r" : "") << std::flush;
  drawn_ = line.size();
}

}  // namespace tolman::app
