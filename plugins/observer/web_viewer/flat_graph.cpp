// SPDX-License-Identifier: BSD-3-Clause
#include "flat_graph.hpp"

#include "container.hpp"

namespace tolman::web_viewer {

void FlatGraph::assign(const MapGraph& graph, std::int64_t at_frame) {
  header = {graph.version, at_frame};
  experience.clear();
  for (const Experience& e : graph.experiences) {
    const Eigen::Vector3d p = e.T_world_experience.translation();
    for (const double x : {p.x(), p.y(), p.z(), toPlanar(e.T_world_experience).theta}) {
      experience.push_back(static_cast<float>(x));
    }
  }
  link.clear();
  link_kind.clear();
  link_rejected.clear();
  link_metres.clear();
  link_seconds.clear();
  for (const Link& l : graph.links) {
    link.push_back(static_cast<std::int32_t>(l.from));
    link.push_back(static_cast<std::int32_t>(l.to));
    link_kind.push_back(static_cast<std::uint8_t>(l.kind));
    link_rejected.push_back(graph.isRejected(l) ? 1 : 0);
    link_metres.push_back(static_cast<float>(l.T_from_to.translation().norm()));
    link_seconds.push_back(static_cast<float>(l.duration));
  }
}

std::string FlatGraph::encode() const {
  const std::size_t nodes = experience.size() / 4;
  const std::size_t links = link_kind.size();
  return encodeContainer(headerJson(header),
                         {pack<float>("experience", {nodes, 4}, experience),
                          pack<std::int32_t>("link", {links, 2}, link),
                          pack<std::uint8_t>("link_kind", {links}, link_kind),
                          pack<std::uint8_t>("link_rejected", {links}, link_rejected)});
}

}  // namespace tolman::web_viewer
