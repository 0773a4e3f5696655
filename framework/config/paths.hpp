// SPDX-License-Identifier: BSD-3-Clause
// Resolves paths of a configuration to absolute paths.
#pragma once

#include <filesystem>
#include <string>

#include "config/problem.hpp"
#include "tolman/status.hpp"

namespace tolman::config {

/// Folders that relative paths refer to.
struct BaseFolders {
  std::filesystem::path working_directory;
  std::string home;  ///< empty when not known
};

/// The absolute, lexically normal path without a trailing slash. `~` is the home folder. A relative
/// path refers to the folder of the file that contains it, or to the working directory if it comes
/// from the command line or a default. An empty path stays empty.
Result<std::string> resolvePath(const std::string& path, const Origin& origin,
                                const BaseFolders& folders);

/// What to say of a path at which nothing usable was found: `missing`, unless this user may not
/// read it or enter a folder on the way, so that nobody can tell whether it is there.
std::string absence(const std::filesystem::path& path, const std::string& missing);

}  // namespace tolman::config
