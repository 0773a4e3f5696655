// SPDX-License-Identifier: BSD-3-Clause
// A new plugin's repository, from the templates that come with the SDK.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tolman/roles.hpp"
#include "tolman/status.hpp"

namespace tolman::app {

/// Why `name` cannot be the id of a plugin, with the remedy; nothing when it can.
std::optional<std::string> objectionTo(const std::string& name);

/// "my_places" to "MyPlaces".
std::string className(const std::string& id);

/// The folder of the templates that belong to a program in PREFIX/bin or in a build tree.
Result<std::filesystem::path> templateFolder(const std::filesystem::path& executable);

/// PREFIX, if it contains an SDK and CMake does not search it by default.
std::optional<std::filesystem::path> unusualPrefix(const std::filesystem::path& executable);

/// Replaces each @NAME@ by its value; a name without a value is left unchanged.
std::string fillIn(const std::string& text, const std::map<std::string, std::string>& values);

struct NewPlugin {
  Role role = Role::Place;
  std::string name;              ///< a legal id
  std::filesystem::path folder;  ///< absent or empty
  bool python = false;           ///< one file in Python instead of a repository in C++
};

/// Writes the repository; returns the files, relative to its folder, in order. A folder that is not
/// empty is refused and left unchanged.
Result<std::vector<std::filesystem::path>> writeNewPlugin(const std::filesystem::path& templates,
                                                          const NewPlugin& plugin);

}  // namespace tolman::app
