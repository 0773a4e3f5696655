// SPDX-License-Identifier: BSD-3-Clause
// A conformance report as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "conformance/check_result.hpp"

namespace tolman::conformance {

/// "ok       reset                after reset() ..." and a line for each finding.
std::string text(const CheckResult& result);

/// The verdict, the number of results of each severity and the seed, in one line.
std::string summary(const ConformanceReport& report);

nlohmann::ordered_json json(const ConformanceReport& report);

}  // namespace tolman::conformance
