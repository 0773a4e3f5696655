// SPDX-License-Identifier: BSD-3-Clause
#include "app/progress_line.hpp"

#include <unistd.h>

#include <algorithm>

namespace tolman::app {

Terminal terminalOf(const Invocation& invocation) {
  return {isatty(STDERR_FILENO) == 1 && !invocation.quiet, invocation.quiet};
}

std::int64_t framesToCome(std::int64_t wanted, std::int64_t known) {
  return wanted < 0 || known < 0 ? std::max(wanted, known) : std::min(wanted, known);
}

ProgressLine::ProgressLine(std::ostream& out, const Clock& clock, Terminal terminal,
                           std::int64_t total)
    : clock_(clock),
      quiet_(terminal.quiet),
      begin_ns_(clock.steadyNs()),
      display_(out, terminal.interactive) {
  frames_.total = total;
  display_.begin(begin_ns_);
}

void ProgressLine::step() {
  if (quiet_) return;
  const std::lock_guard lock(mutex_);
  ++frames_.done;
  const std::int64_t now = clock_.steadyNs();
  frames_.seconds = static_cast<double>(now - begin_ns_) * 1e-9;
  if (display_.isDue(frames_, now)) display_.show(frameText(frames_), frames_, now);
}

}  // namespace tolman::app
