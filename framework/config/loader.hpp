// SPDX-License-Identifier: BSD-3-Clause
// From YAML to one tree: the configuration file, the files that it extends, environment variables,
// and the overrides of the command line. Only this room uses yaml-cpp.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config/tree.hpp"
#include "config/values.hpp"
#include "tolman/status.hpp"

namespace tolman::config {

/// Looks up an environment variable.
using Environment = std::function<std::optional<std::string>(const std::string& name)>;

/// The environment of this process.
Environment processEnvironment();

/// Replaces ${NAME} by the variable, and ${NAME:-default} by the default if the variable is unset
/// or empty. $${ stands for ${. Adds the names to `used`, "A, B (not set)".
Result<std::string> expandVariables(const std::string& text, const Environment& environment,
                                    std::string& used);

/// Reads one YAML document; an empty one gives a Null node. `source` is the origin of all values;
/// line and column are filled in where it is a file. `path` is the key of the document in messages.
/// With an environment its variables are expanded in all values. The result is not parsed as YAML
/// again and counts as unquoted: {port: "${PORT:-8080}"} is a number.
///
/// Stricter than yaml-cpp: of duplicate keys the first is kept and the others are problems. Merge
/// keys, tags, keys that are not scalars, unclosed quotes, control characters, several documents,
/// more than 32 levels and more than 20000 values (aliases count as copies) are problems and give
/// no tree. Does not throw for any input.
std::optional<Node> readYaml(const std::string& text, const Origin& source, Problems& problems,
                             const Environment& environment = {}, const std::string& path = {});

/// Applies each "path=value" to the tree. Parts of a path are keys, or indices of a list
/// ("observers.0.port=1"; the index after the last one appends). The value is YAML: a scalar,
/// [1, 2] or {plugin: x}. Plugins are assigned first, because another plugin removes the parameters
/// of the old one; otherwise later overrides take precedence.
void applyOverrides(Node& tree, const std::vector<std::string>& overrides,
                    const Environment& environment, Problems& problems);

/// Sets one value by such a path, with its own origin. A map is merged into the map that is there,
/// unless it names another plugin.
Status setValue(Node& tree, const std::string& path, const Node& value);

struct Loaded {
  Node tree;             ///< a map, without `extends`
  BaseFolders folders;   ///< for relative paths in the tree
  std::string file;      ///< as given to load()
  Problems problems;     ///< of all files at once
  bool complete = true;  ///< false if a file could not be read: then a missing key is no problem
};

/// The file of a configuration that is shipped with the program, by its name: "demo"; empty where
/// there is none.
using FindShipped = std::function<std::filesystem::path(const std::string&)>;

/// `extends` is a path or a list of paths, relative to the file that contains it, or where no such
/// file exists the name of a shipped configuration. Later files override earlier ones, `file`
/// overrides them all, and `overrides` override `file`. Without a file there are only overrides.
/// Does not throw for the contents of files.
Loaded load(const std::filesystem::path& file, const std::vector<std::string>& overrides,
            const Environment& environment, const FindShipped& find_shipped = {});

}  // namespace tolman::config
