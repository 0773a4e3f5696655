// SPDX-License-Identifier: BSD-3-Clause
// Results of the conformance checks of one plugin.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tolman/fields.hpp"

namespace tolman::conformance {

enum class CheckSeverity : std::uint8_t { Ok, Skip, Warning, Error };
inline constexpr std::array<std::string_view, 4> kCheckSeverityNames = {"ok", "skip", "warning",
                                                                        "error"};
constexpr std::span<const std::string_view> enumNames(CheckSeverity) { return kCheckSeverityNames; }

/// One message of a check. Ok: information, not a fault.
struct CheckFinding {
  CheckSeverity severity = CheckSeverity::Ok;
  std::string message;
  std::string remedy;  ///< what to do; for warnings and errors
};

/// A number that is reported and has no limit.
struct Measurement {
  std::string name;
  double value = 0;
  std::string unit;
};

/// How one check ended.
struct CheckResult {
  std::string check;
  int level = 1;
  std::string demand;  ///< the requirement that was tested
  double seconds = 0;
  std::vector<CheckFinding> findings;
  std::vector<Measurement> measurements;

  /// The worst of the findings.
  CheckSeverity severity() const {
    CheckSeverity worst = CheckSeverity::Ok;
    for (const CheckFinding& finding : findings) worst = std::max(worst, finding.severity);
    return worst;
  }
};

/// The results of one plugin.
struct ConformanceReport {
  std::string file;
  std::string id;
  std::string role;  ///< empty when the manifest could not be read
  int level = 3;
  std::uint64_t seed = 1;
  std::vector<CheckResult> checks;

  std::size_t count(CheckSeverity severity) const {
    return static_cast<std::size_t>(
        std::count_if(checks.begin(), checks.end(),
                      [&](const CheckResult& check) { return check.severity() == severity; }));
  }
  /// At level 3 a warning counts as an error.
  bool conforms() const {
    return count(CheckSeverity::Error) == 0 && (level < 3 || count(CheckSeverity::Warning) == 0);
  }
};

}  // namespace tolman::conformance
