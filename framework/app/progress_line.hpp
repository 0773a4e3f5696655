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

/// "3.7 s", from a minute on "1:04 min", from an hour on "1:02 h".
std::string durationText(double seconds);

/// Kind of stderr, and whether the user wants output there.
struct Terminal {
  bool interactive = false;  ///< stderr is a terminal, on which a line can be redrawn
  bool quiet = false;        ///< show nothing
};
Terminal terminalOf(const Invocation& invocation);

/// The number of frames to expect when at most `wanted` (-1: all) of `known` (-1: unknown) are
/// read.
std::int64_t framesToCome(std::int64_t wanted, std::int64_t known);

/// The last line on a terminal, which is redrawn, and erased at the end.
class StatusLine {
 public:
  explicit StatusLine(std::ostream& out) : out_(out) {}
  ~StatusLine() { redraw(""); }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  /// Shows a line, cut to the width of the terminal.
  void show(const std::string& line);
  /// Adds a line above.
  void add(const std::string& line);

 private:
  void redraw(const std::string& line);

  std::ostream& out_;
  std::size_t drawn_ = 0;  ///< characters of the line on the terminal
};

class ProgressLine {
 public:
  /// `total`: frames to come; -1: not known.
  ProgressLine(std::ostream& out, const Clock& clock, Terminal terminal, std::int64_t total);

  /// One more frame is done. May be called from any thread.
  void step();

 private:
  StatusLine line_;
  const Clock& clock_;
  Terminal terminal_;
  std::mutex mutex_;
  std::int64_t done_ = 0;
  std::int64_t total_;
  std::int64_t begin_ns_;
  std::int64_t shown_ns_;
  std::int64_t shown_tenths_ = 0;
};

}  // namespace tolman::app
