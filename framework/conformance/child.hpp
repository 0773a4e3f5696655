// SPDX-License-Identifier: BSD-3-Clause
// A process that may crash, hang or end itself, and what became of it.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace tolman::conformance {

struct ChildEnd {
  bool timed_out = false;
  int signal = 0;      ///< that ended it; 0 for none
  int exit_code = 0;   ///< without a signal
  std::string output;  ///< the last of what it wrote to stdout and stderr
};

struct ChildLimits {
  double seconds = 60;
  std::size_t memory_mib = 4096;  ///< of its data; 0 for no limit
};

/// Runs `command(descriptor)`, whose process may write lines to that descriptor; each goes to
/// `on_line`. Afterwards the process is gone, and those that it started.
ChildEnd runChild(const std::function<std::vector<std::string>(int descriptor)>& command,
                  const ChildLimits& limits,
                  const std::function<void(const std::string& line)>& on_line);

}  // namespace tolman::conformance
