// SPDX-License-Identifier: BSD-3-Clause
// A catalogue of toy plugins, to check whole configurations without loading plugins.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "config/loader.hpp"
#include "config/system_config.hpp"

namespace tolman::test {

/// The schema of a toy plugin; an empty one for unknown names.
Schema toySchema(const std::string& plugin);

/// An environment of exactly these variables.
config::Environment environmentOf(std::map<std::string, std::string> variables);

/// A configuration after both steps, as the host does them.
struct CheckedSystem {
  config::Loaded loaded;
  config::SystemConfig config;
  config::StageValues values;
  config::Problems problems;

  /// Formatted problems, with the fixtures' folder left out.
  std::string complaints() const;
  const ParameterValues& of(const std::string& instance) const { return values.at(instance); }
};

/// Loads and checks a file of tests/fixtures/config (or any absolute path).
CheckedSystem checkSystem(const std::string& file, const std::vector<std::string>& overrides = {},
                          const std::map<std::string, std::string>& variables = {});

/// The fixtures' folder, with a slash at its end.
std::string fixtures();

/// The text without the fixtures' folder.
std::string withoutFolder(std::string text);

}  // namespace tolman::test
