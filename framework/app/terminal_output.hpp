// SPDX-License-Identifier: BSD-3-Clause
// Names of files and folders may contain control sequences, which a terminal would execute. While
// an object of this class exists, control characters are removed from the stream, line by line.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <streambuf>
#include <string>

namespace tolman::app {

class TerminalOutput : public std::streambuf {
 public:
  explicit TerminalOutput(std::ostream& stream) : stream_(stream), below_(stream.rdbuf(this)) {}
  ~TerminalOutput() override;
  TerminalOutput(const TerminalOutput&) = delete;
  TerminalOutput& operator=(const TerminalOutput&) = delete;

 protected:
  int_type overflow(int_type c) override;
  int sync() override;

 private:
  bool passOn();

  std::ostream& stream_;
  std::streambuf* below_;
  std::string line_;  ///< characters not yet written
};

/// Indented JSON with a line feed at the end; bytes that are not UTF-8 become U+FFFD.
std::string jsonText(const nlohmann::ordered_json& json);

}  // namespace tolman::app
