// SPDX-License-Identifier: BSD-3-Clause
// Examples and exit codes, for the help of a command, its manual page and the documentation.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/exit_code.hpp"

namespace tolman::app {

struct Example {
  std::string_view command;
  std::string_view purpose;  ///< empty if the command needs no explanation
};

struct ExitMeaning {
  ExitCode code;
  std::string_view meaning;
};

/// The examples that begin with `command`, such as "tolman plugins".
std::vector<Example> examplesOf(std::string_view command);
std::span<const ExitMeaning> exitMeanings();

/// Examples and exit codes, as they end the help of `command`.
std::string helpFooter(std::string_view command);

}  // namespace tolman::app
