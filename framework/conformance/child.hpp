// SPDX-License-Identifier: BSD-3-Clause
// Messages between the conformance kit and the process of one check: one line of JSON each.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "conformance/check_result.hpp"
#include "host/child_process.hpp"

namespace tolman::conformance {

/// Message to the process: which check to run on which plugin.
struct CheckTask {
  std::string check;
  int report_descriptor = -1;  ///< where the process writes its messages
  std::string file;
  std::string id;
  std::vector<std::string> set;  ///< "key=value"
  std::uint64_t seed = 1;
  int level = 3;
  std::filesystem::path scratch;
  double timeout_s = 60;            ///< after which the kit kills the process
  std::uint64_t memory_mib = 4096;  ///< 0 for no limit
  std::string program{};            ///< program of an interpreter; empty for other plugins
};
std::string encode(const CheckTask& task);
/// Throws std::exception for what encode() did not write.
CheckTask decodeTask(const std::string& text);

// Messages to the kit.
struct CallStarted {
  std::string call;  ///< "frame 12"
};
/// The input of the calls that follow: "draw 7 of seed 1".
struct CurrentInput {
  std::string description;
};
struct CheckCompleted {};

using CheckMessage =
    std::variant<CallStarted, CurrentInput, CheckFinding, Measurement, CheckCompleted>;
std::string encode(const CheckMessage& message);
/// Nothing for what encode() did not write: a plugin may write to any descriptor.
std::optional<CheckMessage> decodeMessage(const std::string& line);

// Runs a command in a child process that may crash, hang or exit, and reads its report and output.

struct ChildEnd {
  bool timed_out = false;
  host::ProcessEnd process;
  std::string output;  ///< last 300 bytes of stdout and stderr
};

/// Runs `command(descriptor)`. The child may write lines to that descriptor; each is passed to
/// `on_line`. On return the child and all processes of its group have ended. Throws
/// std::exception when it cannot be started.
ChildEnd runChild(const std::function<std::vector<std::string>(int descriptor)>& command,
                  double timeout_s, const std::function<void(const std::string& line)>& on_line);

// Main function of the process that runs one check.

/// Runs the check of an encoded CheckTask and writes its messages to the task's descriptor.
void runCheck(const std::string& task);

}  // namespace tolman::conformance
