// SPDX-License-Identifier: BSD-3-Clause
#include "record/graph_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace tolman::record {
namespace {

/// The least experience of the tree; the way there is made shorter for the next one.
std::size_t rootOf(std::vector<std::size_t>& parents, std::size_t i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

}  // namespace

GraphParts partsOf(const MapGraph& graph) {
  std::vector<std::size_t> parents(graph.experiences.size());
  std::iota(parents.begin(), parents.end(), 0);
  for (const Link& link : graph.links) {
    if (!link.isBelieved()) continue;
    const std::size_t a = rootOf(parents, static_cast<std::size_t>(link.from));
    const std::size_t b = rootOf(parents, static_cast<std::size_t>(link.to));
    parents[std::max(a, b)] = std::min(a, b);
  }
  GraphParts parts;
  for (std::size_t i = 0; i < parents.size(); ++i) {
    const std::size_t root = rootOf(parents, i);
    parts.of_experience.push_back(root == i ? parts.count++ : parts.of_experience[root]);
  }
  return parts;
}

}  // namespace tolman::record
