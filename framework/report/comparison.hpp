// SPDX-License-Identifier: BSD-3-Clause
// The same figure of several runs as one picture: A, B, C in a row, as papers print them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "report/page.hpp"

namespace tolman::report {

/// Figure `file` of each run that has it, in panels of equal height; none when no two runs have it.
std::optional<std::string> sideBySide(const std::vector<RunPage>& runs, std::string_view file);

}  // namespace tolman::report
