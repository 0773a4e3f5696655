// SPDX-License-Identifier: BSD-3-Clause
// Progress, on stderr, of a command that reads frames without a pipeline.
#pragma once

#include <cstdint>
#include <mutex>
#include <ostream>
#include <string>

#include "app/program.hpp"
#include "base/progress_display.hpp"
#include "tolman/context.hpp"

namespace tolman::app {

/// Kind of stderr, and whether the user wants output there.
struct Terminal {
  bool interactive = false;  ///< stderr is a terminal, on which a line can be redrawn
  bool quiet = false;        ///< show nothing
};
Terminal terminalOf(const Invocation& invocation);

/// The number of frames to expect when at most `wanted` (-1: all) of `known` (-1: unknown) are
/// read.
std::int64_t framesToCome(std::int64_t wanted, std::int64_t known);

class ProgressLine {
 public:
  /// `total`: frames to come; -1: not known.
  ProgressLine(std::ostream& out, const Clock& clock, Terminal terminal, std::int64_t total);
  /// One more frame is done. May be called from any thread.
  void step();

 private:
  const Clock& clock_;
  bool quiet_;
  std::mutex mutex_;
  FrameCount frames_;
  std::int64_t begin_ns_;
  ProgressDisplay display_;
};

}  // namespace tolman::app
