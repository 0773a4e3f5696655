// SPDX-License-Identifier: BSD-3-Clause
// The inside of the process that makes one check.
#pragma once

#include <string>

namespace tolman::conformance {

/// Makes the check of an encoded Task and reports to its descriptor. Whatever the plugin does to
/// this process, the kit outside sees it.
void runCheck(const std::string& task);

}  // namespace tolman::conformance
