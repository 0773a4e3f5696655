// SPDX-License-Identifier: BSD-3-Clause
// Main function of the process that runs one check.
#pragma once

#include <string>

namespace tolman::conformance {

/// Runs the check of an encoded CheckTask and writes its messages to the task's descriptor.
void runCheck(const std::string& task);

}  // namespace tolman::conformance
