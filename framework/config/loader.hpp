// SPDX-License-Identifier: BSD-3-Clause
// Loads a configuration file, the files that it extends, and the overrides of the command line into
// one tree.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "config/node.hpp"
#include "config/paths.hpp"
#include "config/variables.hpp"

namespace tolman::config {

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
/// overrides them all, and `overrides` override `file`. Does not throw for the contents of files.
Loaded load(const std::filesystem::path& file, const std::vector<std::string>& overrides,
            const Environment& environment, const FindShipped& find_shipped = {});

}  // namespace tolman::config
