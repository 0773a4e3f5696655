// SPDX-License-Identifier: BSD-3-Clause
// What a path in a configuration means.
#pragma once

#include <filesystem>
#include <string>

#include "config/problem.hpp"
#include "tolman/status.hpp"

namespace tolman::config {

/// The folders that paths may start from.
struct Places {
  std::filesystem::path working_directory;
  std::string home;  ///< empty when not known
};

/// Absolute and lexically normal, without a slash at the end. `~` is the home folder. A relative
/// path starts from the folder of the file that says it, or from the working directory when the
/// command line or a default says it. Empty stays empty.
Result<std::string> resolvePath(const std::string& path, const Origin& origin,
                                const Places& places);

}  // namespace tolman::config
