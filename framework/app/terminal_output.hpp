// SPDX-License-Identifier: BSD-3-Clause
// Names of files and folders may contain control sequences, which a terminal would obey. While an
// object lives, what is written to the stream appears without them, line by line.
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
  std::string line_;  ///< not yet passed on
};

/// Indented, with a line feed; names of files that are no UTF-8 with U+FFFD in them.
std::string jsonText(const nlohmann::ordered_json& json);

}  // namespace tolman::app
