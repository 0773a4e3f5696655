// SPDX-License-Identifier: BSD-3-Clause
#include "record/graph_parts.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

namespace tolman::record {

GraphParts partsOf(const MapGraph& graph) {
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> links(
      graph.experiences.size());
  for (const Link& link : graph.links) {
    if (graph.isRejected(link)) continue;
    add_edge(static_cast<std::size_t>(link.from), static_cast<std::size_t>(link.to), links);
  }
  GraphParts parts{std::vector<std::int64_t>(graph.experiences.size()), 0};
  parts.count = boost::connected_components(links, parts.of_experience.data());
  return parts;
}

}  // namespace tolman::record
