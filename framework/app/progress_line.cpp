// SPDX-License-Identifier: BSD-3-Clause
#include "app/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "engine/services.hpp"

namespace tolman::app {
namespace {

/// "frame 40 of 100 (40 %), 9.8 frames/s, 6.1 s left"
std::string frameText(std::int64_t done, std::int64_t total, double seconds) {
  std::string text = fmt::format("frame {}", done);
  if (total > 0) text += fmt::format(" of {} ({} %)", total, std::min(100 * done / total, 100L));
  const double rate = seconds > 0 ? static_cast<double>(done) / seconds : 0;
  text += fmt::format(", {:.1f} frames/s", rate);
  if (total < done || rate <= 0) return text;
  return text + ", " + durationText(static_cast<double>(total - done) / rate) + " left";
}

}  // namespace

std::string durationText(double seconds) {
  const double known = std::isfinite(seconds) ? std::clamp(seconds, 0.0, 1e9) : 0.0;
  const long long tenths = std::llround(10 * known);
  if (tenths < 600) return fmt::format("{}.{} s", tenths / 10, tenths % 10);
  const long long whole = std::llround(known);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  const long long minutes = std::llround(known / 60);
  return fmt::format("{}:{:02} h", minutes / 60, minutes % 60);
}

Terminal terminalOf(const Invocation& invocation) {
  return {isatty(STDERR_FILENO) == 1 && !invocation.quiet, invocation.quiet};
}

std::int64_t framesToCome(std::int64_t wanted, std::int64_t known) {
  return wanted < 0 || known < 0 ? std::max(wanted, known) : std::min(wanted, known);
}

void StatusLine::redraw(const std::string& line) {
  if (line.empty() && drawn_ == 0) return;
  const std::string wipe(drawn_ > line.size() ? drawn_ - line.size() : 0, ' ');
  // One write, so that no log line of another thread comes in between.
  out_ << "\r" + line + wipe + (line.empty() ? "\r" : "") << std::flush;
  drawn_ = line.size();
}

void StatusLine::show(const std::string& line) {
  const int width = engine::terminalWidth(STDERR_FILENO) - 1;
  redraw(line.substr(0, static_cast<std::size_t>(std::max(width, 0))));
}

void StatusLine::add(const std::string& line) {
  redraw("");
  out_ << line + "\n" << std::flush;
}

ProgressLine::ProgressLine(std::ostream& out, const Clock& clock, Terminal terminal,
                           std::int64_t total)
    : line_(out),
      clock_(clock),
      terminal_(terminal),
      total_(total),
      begin_ns_(clock.steadyNs()),
      shown_ns_(begin_ns_) {}

void ProgressLine::step() {
  constexpr std::int64_t kRedrawNs = 100'000'000;     // ten times a second
  constexpr std::int64_t kSilenceNs = 5'000'000'000;  // longest time without a line
  if (terminal_.quiet) return;
  const std::lock_guard lock(mutex_);
  ++done_;
  const std::int64_t now = clock_.steadyNs();
  const std::int64_t tenths = total_ > 0 ? 10 * done_ / total_ : 0;
  const bool due = terminal_.interactive ? now - shown_ns_ >= kRedrawNs
                                         : tenths > shown_tenths_ || now - shown_ns_ >= kSilenceNs;
  if (!due) return;
  const std::string text = frameText(done_, total_, static_cast<double>(now - begin_ns_) * 1e-9);
  if (terminal_.interactive) {
    line_.show(text);
  } else {
    line_.add(text);
  }
  shown_ns_ = now;
  shown_tenths_ = tenths;
}

}  // namespace tolman::app
