// SPDX-License-Identifier: BSD-3-Clause
// Runs `tolman plugins validate --json` and reads its report.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "end_to_end/process.hpp"
#include "support/paths.hpp"

namespace tolman::test {

inline std::string fixtureLibrary(const std::string& name) {
  return inBuild("tests/fixtures/plugins/") + name + "/tolman_odometry_" + name + ".so";
}

struct Validation {
  int exit_code = 0;
  nlohmann::json reports;  ///< one per plugin

  /// All messages of all findings.
  std::string messages() const {
    std::string text;
    for (const auto& report : reports) {
      for (const auto& check : report["checks"]) {
        for (const auto& finding : check["findings"]) {
          text += finding["message"].get<std::string>() + "\n";
        }
      }
    }
    return text;
  }
  /// A check of the first report.
  nlohmann::json check(const std::string& id) const {
    for (const auto& check : reports.at(0)["checks"]) {
      if (check["check"] == id) return check;
    }
    return {};
  }
};

inline Validation validate(const std::string& file, const std::vector<std::string>& options) {
  std::vector<std::string> arguments = {"plugins", "validate", file, "--json"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Finished finished = tolman(arguments);
  INFO(finished.err);
  Validation validation{finished.exit_code, nlohmann::json::parse(finished.out, nullptr, false)};
  REQUIRE_FALSE(validation.reports.is_discarded());
  return validation;
}

}  // namespace tolman::test
