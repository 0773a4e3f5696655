// SPDX-License-Identifier: BSD-3-Clause
// A report for people and for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "conformance/finding.hpp"

namespace tolman::conformance {

/// "ok       reset                after reset() ..." and a line for each finding.
std::string text(const CheckResult& result);

/// What it comes to: counts, figures and how to repeat it.
std::string summary(const Report& report);

nlohmann::ordered_json json(const Report& report);

}  // namespace tolman::conformance
