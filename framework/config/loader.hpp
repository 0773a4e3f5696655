// SPDX-License-Identifier: BSD-3-Clause
// From YAML to one tree: the configuration file, the files that it extends, environment variables,
// and the overrides of the command line.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "config/tree.hpp"
#include "config/values.hpp"
#include "tolman/status.hpp"

namespace tolman::config {

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
  Node tree;            ///< a map, without `extends`
  BaseFolders folders;  ///< for relative paths in the tree
  std::string file;     ///< as given to load()
  Problems problems;    ///< of all files at once
  /// Parameters that went with a plugin which an override replaces.
  std::vector<std::string> notes{};
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
