// SPDX-License-Identifier: BSD-3-Clause
#include "config/differences.hpp"

#include <algorithm>
#include <map>

namespace tolman::config {
namespace {

using Values = std::map<std::string, std::string>;

void leaves(const Node& node, const std::string& path, Values& values) {
  if (node.isScalar()) values[path] = node.text;
  for (const Node& child : node.children) leaves(child, joinPath(path, child.key), values);
}

}  // namespace

std::vector<Difference> differencesOf(const std::vector<const Node*>& trees) {
  std::vector<Values> all;
  Values keys;
  for (const Node* tree : trees) {
    leaves(*tree, "", all.emplace_back());
    keys.insert(all.back().begin(), all.back().end());
  }
  std::vector<Difference> differences;
  for (const auto& [key, first] : keys) {
    Difference difference{key, {}};
    for (const Values& values : all) {
      const auto own = values.find(key);
      difference.values.push_back(own == values.end() ? "-" : own->second);
    }
    const bool is_same = std::ranges::count(difference.values, difference.values.front()) ==
                         std::ranges::ssize(difference.values);
    if (!is_same) differences.push_back(std::move(difference));
  }
  return differences;
}

}  // namespace tolman::config
