// SPDX-License-Identifier: BSD-3-Clause
#include "flat_graph.hpp"

#include "container.hpp"

namespace tolman::web_viewer {

void FlatGraph::take(const MapGraph& graph, std::int64_t at_frame) {
  version = graph.version;
  frame = at_frame;
  experience.clear();
  experience_frame.clear();
  experience_template.clear();
  for (const Experience& e : graph.experiences) {
    const Eigen::Vector3d p = e.T_world_experience.translation();
    for (const double x : {p.x(), p.y(), p.z(), toPlanar(e.T_world_experience).theta}) {
      experience.push_back(static_cast<float>(x));
    }
    experience_frame.push_back(static_cast<std::int32_t>(e.frame));
    experience_template.push_back(static_cast<std::int32_t>(e.template_id));
  }
  link.clear();
  link_kind.clear();
  link_weight.clear();
  for (const Link& l : graph.links) {
    link.push_back(static_cast<std::int32_t>(l.from));
    link.push_back(static_cast<std::int32_t>(l.to));
    link_kind.push_back(static_cast<std::uint8_t>(l.kind));
    link_weight.push_back(static_cast<float>(l.weight));
  }
}

std::string FlatGraph::encode() const {
  const std::size_t nodes = experience_frame.size();
  const std::size_t links = link_kind.size();
  const nlohmann::json header = {{"type", "graph"}, {"version", version}, {"frame", frame}};
  return encodeContainer(header,
                         {pack<float>("experience", {nodes, 4}, experience),
                          pack<std::int32_t>("experience_frame", {nodes}, experience_frame),
                          pack<std::int32_t>("experience_template", {nodes}, experience_template),
                          pack<std::int32_t>("link", {links, 2}, link),
                          pack<std::uint8_t>("link_kind", {links}, link_kind),
                          pack<float>("link_weight", {links}, link_weight)});
}

}  // namespace tolman::web_viewer
