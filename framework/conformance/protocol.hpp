// SPDX-License-Identifier: BSD-3-Clause
// What the kit and the process of one check tell each other: one line of JSON each.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "conformance/lab.hpp"

namespace tolman::conformance {

/// The task of a process: a check, and where to report.
struct Task {
  std::string check;
  int report_descriptor = -1;
  LabOptions lab;
};
std::string encode(const Task& task);
/// Throws std::exception for what encode() did not write.
Task decodeTask(const std::string& text);

/// The call that comes next.
struct Step {
  std::string what;
};
/// What the calls from now on are about: "draw 7 of seed 1".
struct Topic {
  std::string what;
};
/// The check is complete.
struct Done {};

using Message = std::variant<Step, Topic, Finding, Figure, Done>;
std::string encode(const Message& message);
/// Nothing for what encode() did not write: plugins may write where they should not.
std::optional<Message> decodeMessage(const std::string& line);

}  // namespace tolman::conformance
