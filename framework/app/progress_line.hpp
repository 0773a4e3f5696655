// SPDX-License-Identifier: BSD-3-Clause
// Progress, on stderr, of a command that reads frames without a pipeline. On a terminal one line is
// redrawn; elsewhere a line is added after each tenth of the frames, or after five seconds.
#pragma once

#include <cstdint>
#include <mutex>
#include <ostream>
#include <string>

#include "app/program.hpp"
#include "tolman/context.hpp"

namespace tolman::app {

/// Kind of stderr, and whether the user wants output there.
struct Terminal {
  bool interactive = false;  ///< stderr is a terminal, on which a line can be redrawn
  bool quiet = false;        ///< show nothing
};
Terminal terminalOf(const Invocation& invocation);

struct FrameCount {
  std::int64_t done = 0;
  std::int64_t total = -1;  ///< -1: not known
  double seconds = 0;       ///< since the beginning
};

/// "[====>     ] 40 %  40/100  9.8 frames/s  6.1 s left", cut from the right to fit `width`.
std::string barText(const FrameCount& count, int width);
/// "frame 40 of 100 (40 %), 9.8 frames/s, 6.1 s left"
std::string plainText(const FrameCount& count);

/// The number of frames to expect when at most `wanted` (-1: all) of `known` (-1: unknown) are
/// read.
std::int64_t framesToCome(std::int64_t wanted, std::int64_t known);

class ProgressLine {
 public:
  ProgressLine(std::ostream& out, const Clock& clock, Terminal terminal, std::int64_t total);
  /// Erases the line on a terminal.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// One more frame is done. May be called from any thread.
  void step();

 private:
  void redraw(const std::string& line);

  std::ostream& out_;
  const Clock& clock_;
  Terminal terminal_;
  std::mutex mutex_;
  FrameCount count_;
  std::int64_t begin_ns_;
  std::int64_t shown_ns_;
  std::int64_t shown_tenths_ = 0;
  std::size_t drawn_ = 0;  ///< characters of the line on the terminal
};

}  // namespace tolman::app
