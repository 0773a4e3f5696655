// SPDX-License-Identifier: BSD-3-Clause
// Runs a command in a child process that may crash, hang or exit, and reads its report and output.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/child_process.hpp"

namespace tolman::conformance {

struct ChildEnd {
  bool timed_out = false;
  isolation::ProcessEnd process;
  std::string output;  ///< last 300 bytes of stdout and stderr
};

/// Runs `command(descriptor)`. The child may write lines to that descriptor; each is passed to
/// `on_line`. On return the child and all processes of its group have ended. Throws
/// std::exception when it cannot be started.
ChildEnd runChild(const std::function<std::vector<std::string>(int descriptor)>& command,
                  double timeout_s, const std::function<void(const std::string& line)>& on_line);

}  // namespace tolman::conformance
