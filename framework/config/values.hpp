// SPDX-License-Identifier: BSD-3-Clause
// Values of a configuration: numbers, booleans and paths as text, and their check against the
// declarations of parameters, the host's own keys and those of plugins alike.
//
// YAML 1.1 reads 010 as eight, 0x10 as sixteen, `on` as true and `.nan` as a number. These
// spellings are refused, because other YAML readers differ; the message gives the unambiguous one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "config/tree.hpp"
#include "tolman/parameters.hpp"
#include "tolman/status.hpp"

namespace tolman::config {

/// Decimal digits with an optional sign. Not 010, 0x10, 1e3, 2.0.
Result<std::int64_t> readInteger(const std::string& text);

/// A finite decimal number, 1e-3 included. Not 010, 0x10, .nan, .inf.
Result<double> readReal(const std::string& text);

/// `true` or `false` only.
Result<bool> readBool(const std::string& text);

/// The shortest text from which readReal() gives the same number.
std::string writeReal(double value);

/// A YAML scalar that is read as exactly this text, quoted where it must be.
std::string writeText(const std::string& text);

/// A value as YAML that is read as the same value.
std::string writeValue(const ParameterValue& value);

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
/// read it or enter a folder on the way, so that its existence is not known.
std::string absence(const std::filesystem::path& path, const std::string& missing);

/// Which parameters are checked.
struct Subject {
  std::string path;   ///< of the map: "odometry", "observers.0", "" at the top
  std::string owner;  ///< for messages: "plugin kitti"; empty for the host's own keys
  std::vector<std::string> also_known;  ///< legal keys that are checked elsewhere
};

/// Values of all parameters, defaults included. Unknown keys, wrong types, values out of range and
/// missing required values are all reported; such a parameter keeps its default.
ParameterValues check(const Node& map, const Schema& schema, const Subject& subject,
                      const BaseFolders& folders, Problems& problems);

}  // namespace tolman::config
