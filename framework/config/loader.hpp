// SPDX-License-Identifier: BSD-3-Clause
// A configuration file with all that it extends and the command line, as one tree.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/node.hpp"
#include "config/paths.hpp"
#include "config/variables.hpp"

namespace tolman::config {

struct Loaded {
  Node tree;             ///< a map, without `extends`
  Places places;         ///< for paths in the tree
  std::string file;      ///< as given to load()
  Problems problems;     ///< of all files at once
  bool complete = true;  ///< false: a file or a part is missing, so what is absent proves nothing
};

/// Reads `file`, lays it over the files that its `extends` names (a path or a list, relative to the
/// file that says it; the later wins, the file itself over all), then applies the `overrides` of
/// the command line. Never throws for what files hold.
Loaded load(const std::filesystem::path& file, const std::vector<std::string>& overrides,
            const Environment& environment);

}  // namespace tolman::config
