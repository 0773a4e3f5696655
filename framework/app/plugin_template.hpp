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

/// The role of this name, or what the roles are.
Result<Role> roleNamed(const std::string& name);

/// "my_places" to "MyPlaces".
std::string className(const std::string& id);

/// The folder of the templates beside a program in PREFIX/bin, also of a build tree.
Result<std::filesystem::path> templateFolder(const std::filesystem::path& executable);

/// PREFIX, when an SDK lies below it where CMake does not look by itself.
std::optional<std::filesystem::path> unusualPrefix(const std::filesystem::path& executable);

/// Puts values in for @NAMES@; a name without a value stays as it is.
std::string fillIn(const std::string& text, const std::map<std::string, std::string>& values);

struct NewPlugin {
  Role role = Role::Place;
  std::string name;              ///< a legal id
  std::filesystem::path folder;  ///< absent or empty
  bool python = false;           ///< one file in Python instead of a repository in C++
};

/// Writes the repository; gives the files, relative to its folder, in order. A folder that holds
/// anything is refused and left as it is.
Result<std::vector<std::filesystem::path>> writeNewPlugin(const std::filesystem::path& templates,
                                                          const NewPlugin& plugin);

}  // namespace tolman::app
