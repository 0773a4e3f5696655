// SPDX-License-Identifier: BSD-3-Clause
// Finds the keys in which configurations differ.
#pragma once

#include <string>
#include <vector>

#include "config/node.hpp"

namespace tolman::config {

struct Difference {
  std::string key;                  ///< "cells.period"
  std::vector<std::string> values;  ///< of each tree; "-" where it has no such key
};

/// Scalars that are not the same in all trees, by key.
std::vector<Difference> differencesOf(const std::vector<const Node*>& trees);

}  // namespace tolman::config
