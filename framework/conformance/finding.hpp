// SPDX-License-Identifier: BSD-3-Clause
// What the kit has to say.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tolman/fields.hpp"

namespace tolman::conformance {

enum class Severity : std::uint8_t { Ok, Skip, Warning, Error };
inline constexpr std::array<std::string_view, 4> kSeverityNames = {"ok", "skip", "warning",
                                                                   "error"};
constexpr std::span<const std::string_view> enumNames(Severity) { return kSeverityNames; }

/// One thing that was found. Ok: something worth knowing, not a fault.
struct Finding {
  Severity severity = Severity::Ok;
  std::string message;
  std::string remedy;  ///< what to do; for warnings and errors
};

/// A number that is reported and never judged.
struct Figure {
  std::string name;
  double value = 0;
  std::string unit;
};

/// How one check ended.
struct CheckResult {
  std::string check;
  int level = 1;
  std::string demand;  ///< what the check asks of a plugin
  double seconds = 0;
  std::vector<Finding> findings;
  std::vector<Figure> figures;

  /// The worst of the findings.
  Severity severity() const {
    Severity worst = Severity::Ok;
    for (const Finding& finding : findings) worst = std::max(worst, finding.severity);
    return worst;
  }
};

/// All that was found about one plugin.
struct Report {
  std::string file;
  std::string id;
  std::string role;  ///< empty when not even the manifest could be read
  int level = 3;
  std::uint64_t seed = 1;
  std::vector<CheckResult> checks;

  std::size_t count(Severity severity) const {
    return static_cast<std::size_t>(
        std::count_if(checks.begin(), checks.end(),
                      [&](const CheckResult& check) { return check.severity() == severity; }));
  }
  /// At the strictest level a warning is as bad as an error.
  bool conforms() const {
    return count(Severity::Error) == 0 && (level < 3 || count(Severity::Warning) == 0);
  }
};

}  // namespace tolman::conformance
