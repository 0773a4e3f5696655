// SPDX-License-Identifier: BSD-3-Clause
// The conformance kit: runs the checks of one plugin, each in its own process, and reports.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "tolman/context.hpp"
#include "tolman/roles.hpp"

namespace tolman::conformance {

enum class CheckSeverity : std::uint8_t { Ok, Skip, Warning, Error };
inline constexpr std::array<std::string_view, 4> kCheckSeverityNames = {"ok", "skip", "warning",
                                                                        "error"};
constexpr std::span<const std::string_view> enumNames(CheckSeverity) { return kCheckSeverityNames; }

/// How one check ended.
struct CheckResult {
  std::string check;
  int level = 1;
  std::string demand;  ///< the requirement that was tested
  double seconds = 0;
  std::vector<Finding> findings{};
  bool skipped = false;

  /// The worst of the findings.
  CheckSeverity severity() const {
    CheckSeverity worst = skipped ? CheckSeverity::Skip : CheckSeverity::Ok;
    for (const Finding& finding : findings) {
      if (finding.severity == Finding::Severity::Note) continue;
      const bool is_error = finding.severity == Finding::Severity::Error;
      worst = std::max(worst, is_error ? CheckSeverity::Error : CheckSeverity::Warning);
    }
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

  std::int64_t count(CheckSeverity severity) const {
    return std::ranges::count(checks, severity, &CheckResult::severity);
  }
  /// At level 3 a warning counts as an error.
  bool conforms() const {
    return count(CheckSeverity::Error) == 0 && (level < 3 || count(CheckSeverity::Warning) == 0);
  }
};

/// "ok       reset                after reset() ..." and a line for each finding.
std::string text(const CheckResult& result);

/// The verdict, the number of results of each severity and the seed, in one line.
std::string summary(const ConformanceReport& report);

nlohmann::ordered_json json(const ConformanceReport& report);

struct KitOptions {
  std::vector<std::string> program;  ///< command that calls runCheck(); the task is appended
  std::string file;
  std::string id;                 ///< of the plugin in the file
  std::string program_file;       ///< program of an interpreter; empty for other plugins
  std::vector<std::string> set;   ///< "key=value"
  std::vector<std::string> only;  ///< ids of checks; empty for all
  int level = 3;
  std::uint64_t seed = 1;
  double timeout = 60;              ///< s for each check
  std::uint64_t memory_mib = 4096;  ///< for each check; 0 for no limit
};

using OnCheckResult = std::function<void(const CheckResult&)>;

/// Runs the checks of `role` up to the level and calls `on_result` after each. Stops when the
/// plugin cannot be loaded, or after three checks that timed out.
ConformanceReport validate(const KitOptions& options, Role role, const OnCheckResult& on_result);

/// Main function of the process of one check: `task` is what the kit has appended.
void runCheck(const std::string& task);

/// In the order in which they run.
std::vector<std::string> checkIds();

}  // namespace tolman::conformance
