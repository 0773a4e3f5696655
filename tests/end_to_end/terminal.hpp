// SPDX-License-Identifier: BSD-3-Clause
// Runs a program on its own pseudo-terminal, and reads the visible text.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

namespace tolman::test {

class Terminal {
 public:
  explicit Terminal(const std::vector<std::string>& command, int columns = 100);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  void type(std::string_view keys) const;
  /// Reads until `text` has been written behind what was waited for before; false after 60 s.
  bool waitFor(const std::string& text);
  /// Reads to the end of the program; its exit code, or 128 + signal.
  int finish();
  const std::string& output() const { return output_; }

 private:
  /// False when the program has ended, or has been silent for this time.
  bool read(int milliseconds);

  pid_t pid_ = -1;
  int master_ = -1;
  std::string output_;
  std::size_t waited_ = 0;  ///< characters of the output up to what was waited for
};

/// The lines that a terminal shows after this output, without blanks at their ends. Carriage
/// returns overwrite; sequences for colours are left out.
std::vector<std::string> shownLines(const std::string& output, std::size_t columns);

}  // namespace tolman::test
