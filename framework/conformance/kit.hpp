// SPDX-License-Identifier: BSD-3-Clause
// A conformance report as text and as JSON.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "conformance/check.hpp"

namespace tolman::conformance {

/// "ok       reset                after reset() ..." and a line for each finding.
std::string text(const CheckResult& result);

/// The verdict, the number of results of each severity and the seed, in one line.
std::string summary(const ConformanceReport& report);

nlohmann::ordered_json json(const ConformanceReport& report);

// The conformance kit: runs the checks of one plugin, each in its own process.

struct KitOptions {
  std::vector<std::string> program;  ///< command that calls runCheck(); the task is appended
  std::string file;
  std::string id;                 ///< of the plugin in the file
  std::string program_file;       ///< program of an interpreter; empty for other plugins
  std::vector<std::string> set;   ///< "key=value"
  std::vector<std::string> only;  ///< ids of checks; empty for all
  int level = 3;
  std::uint64_t seed = 1;
  double timeout = 60;            ///< s for each check
  std::size_t memory_mib = 4096;  ///< for each check
};

using OnCheckResult = std::function<void(const CheckResult&)>;

/// Runs the checks of `role` up to the level and calls `on_result` after each. Stops when the
/// plugin cannot be loaded, or after three checks that timed out.
ConformanceReport validate(const KitOptions& options, Role role, const OnCheckResult& on_result);

}  // namespace tolman::conformance
