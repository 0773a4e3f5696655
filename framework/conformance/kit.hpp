// SPDX-License-Identifier: BSD-3-Clause
// The conformance kit: all checks of one plugin, each in a process of its own.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "conformance/check.hpp"
#include "conformance/finding.hpp"

namespace tolman::conformance {

struct KitOptions {
  std::vector<std::string> program;  ///< starts runCheck() with one more argument, the task
  std::string file;
  std::string id;                 ///< of the plugin in the file
  std::vector<std::string> set;   ///< "key=value"
  std::vector<std::string> only;  ///< ids of checks; empty for all
  int level = 3;
  std::uint64_t seed = 1;
  double timeout = 60;            ///< s for each check
  std::size_t memory_mib = 4096;  ///< for each check
};

/// Called after each check.
using Progress = std::function<void(const CheckResult&)>;

/// Makes the checks of `role` up to the level. When the plugin cannot be loaded, or three checks
/// hung, the rest is left out.
Report validate(const KitOptions& options, Role role, const Progress& progress);

}  // namespace tolman::conformance
