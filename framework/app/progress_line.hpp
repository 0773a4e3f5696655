// SPDX-License-Identifier: BSD-3-Clause
// How far a command is that drives frames without a pipeline: a redrawn line on a terminal, a line
// now and then elsewhere.
#pragma once

#include <cstdint>
#include <mutex>
#include <ostream>
#include <string>

#include "app/assembly.hpp"

namespace tolman::app {

struct FrameCount {
  std::int64_t done = 0;
  std::int64_t total = -1;  ///< -1: not known
  double seconds = 0;
};

/// "[====>     ] 40 %  40/100  9.8 frames/s  0:06 left", cut from the right to fit `width`.
std::string barText(const FrameCount& count, int width);
/// "frame 40 of 100 (40 %), 9.8 frames/s, 0:06 left"
std::string plainText(const FrameCount& count);

/// How many frames will come when `wanted` are asked for and there are `known`; -1: all, not known.
std::int64_t framesToCome(std::int64_t wanted, std::int64_t known);

class ProgressLine {
 public:
  ProgressLine(std::ostream& out, const Clock& clock, const Audience& audience, std::int64_t total);
  /// Wipes the line of the terminal.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// One more frame is done. Any thread.
  void step();

 private:
  void redraw(const std::string& line);

  std::ostream& out_;
  const Clock& clock_;
  Audience audience_;
  std::mutex mutex_;
  FrameCount count_;
  std::int64_t begin_ns_;
  std::int64_t shown_ns_;
  std::int64_t shown_tenths_ = 0;
  std::size_t drawn_ = 0;  ///< characters that stand on the terminal
};

}  // namespace tolman::app
