// SPDX-License-Identifier: BSD-3-Clause
// How far something is, on a stream: on a terminal one line that is redrawn, elsewhere a line after
// each tenth, or after a silence.
#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>

namespace tolman {

/// "3.7 s", from a minute on "1:04 min", from an hour on "1:02 h".
std::string durationText(double seconds);

/// Frames so far.
struct FrameCount {
  std::int64_t done = 0;
  std::int64_t total = -1;    ///< -1: not known
  std::int64_t left_out = 0;  ///< of those done; not part of the speed
  double seconds = 0;
};

/// "9.8 frames/s"
std::string speedText(const FrameCount& count);
/// "frame 40 of 100 (40 %), 9.8 frames/s, 6.1 s left"
std::string frameText(const FrameCount& count);

/// Columns of the terminal of stderr; 80 if that is not known.
int terminalWidth();

/// The last line on a terminal, which is redrawn, and erased at the end.
class StatusLine {
 public:
  /// `width`: columns of the terminal; called before each drawing.
  explicit StatusLine(std::ostream& out, std::function<int()> width = terminalWidth)
      : out_(out), width_(std::move(width)) {}
  ~StatusLine() { erase(); }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  /// Shows a line, cut to the width of the terminal.
  void show(const std::string& line);
  /// Adds a line above.
  void add(const std::string& line);
  void erase();
  /// Leaves the line where it is, and what comes next to a line of its own.
  void keep();

 private:
  void redraw(const std::string& line);

  std::ostream& out_;
  std::function<int()> width_;
  std::size_t drawn_ = 0;  ///< characters of the line on the terminal
};

class ProgressDisplay {
 public:
  ProgressDisplay(std::ostream& out, bool interactive, std::function<int()> width = terminalWidth)
      : line_(out, std::move(width)), interactive_(interactive) {}

  void begin(std::int64_t now_ns);
  /// On a terminal ten times a second; elsewhere at each tenth, and after a silence of five
  /// seconds, later of a tenth of the time so far.
  bool isDue(const FrameCount& count, std::int64_t now_ns) const;
  void show(const std::string& text, const FrameCount& count, std::int64_t now_ns);
  StatusLine& line() { return line_; }

 private:
  StatusLine line_;
  bool interactive_;
  std::int64_t begin_ns_ = 0;
  std::int64_t shown_ns_ = 0;
  std::int64_t shown_tenths_ = 0;
};

}  // namespace tolman
