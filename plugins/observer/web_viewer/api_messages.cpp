// SPDX-License-Identifier: BSD-3-Clause
#include "api_messages.hpp"

#include "container.hpp"

namespace tolman::web_viewer {
namespace {

using Json = nlohmann::ordered_json;

double seconds(std::int64_t ns) { return static_cast<double>(ns) * 1e-9; }

/// JSON text. Invalid UTF-8, for example in names of files, is replaced.
std::string textOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json poseJson(const LatestPose& pose) {
  const Eigen::Vector3d p = pose.T_world_camera.translation();
  const Eigen::Quaterniond q(pose.T_world_camera.linear());
  return {
      {"frame", pose.frame},
      {"time_s", seconds(pose.stamp_ns)},
      {"state", enumName(pose.state)},
      {"scale_known", pose.scale_known},
      {"experience", pose.experience},
      {"right_m", p.x()},
      {"forward_m", p.z()},
      {"up_m", 0 - p.y()},
      {"heading_rad", toPlanar(pose.T_world_camera).theta},
      {"T_world_camera",
       {{"position_m", {p.x(), p.y(), p.z()}}, {"rotation_xyzw", {q.x(), q.y(), q.z(), q.w()}}}}};
}

Json loopMessage(std::int64_t frame, std::int64_t seen_at, std::int64_t experience) {
  return {{"type", "loop"}, {"frame", frame}, {"seen_at", seen_at}, {"experience", experience}};
}

}  // namespace

ApiAnswer poseAnswer(const LatestPose& pose) {
  if (pose.frame < 0) return {404, R"({"error":"there is no pose yet"})"};
  return {200, textOf(poseJson(pose))};
}

ApiAnswer mapAnswer(const FlatGraph& graph) {
  Json experiences = Json::array();
  for (std::size_t i = 0; 4 * i < graph.experience.size(); ++i) {
    const float* e = graph.experience.data() + 4 * i;
    experiences.push_back({{"id", i},
                           {"right_m", e[0]},
                           {"forward_m", e[2]},
                           {"up_m", 0 - e[1]},
                           {"heading_rad", e[3]}});
  }
  Json links = Json::array();
  for (std::size_t i = 0; i < graph.link_kind.size(); ++i) {
    links.push_back({{"from", graph.link[2 * i]},
                     {"to", graph.link[2 * i + 1]},
                     {"kind", enumName(static_cast<LinkKind>(graph.link_kind[i]))},
                     {"rejected", graph.link_rejected[i] != 0},
                     {"metres", graph.link_metres[i]},
                     {"seconds", graph.link_seconds[i]}});
  }
  return {200, textOf({{"version", graph.header.version},
                       {"frame", graph.header.frame},
                       {"experiences", std::move(experiences)},
                       {"links", std::move(links)}})};
}

std::string poseMessage(const LatestPose& pose) {
  Json json = {{"type", "pose"}};
  json.update(poseJson(pose));
  return textOf(json);
}

std::string endMessage(std::string_view state, std::int64_t frame) {
  return textOf({{"type", "end"}, {"state", state}, {"frame", frame}});
}

void appendMessages(const Snapshot& snapshot, std::vector<std::string>& messages) {
  const Decision* decision = snapshot.decision;
  if (decision != nullptr && decision->action != Action::Stay) {
    messages.push_back(textOf({{"type", "decision"},
                               {"frame", snapshot.frame->frame},
                               {"time_s", seconds(snapshot.frame->stamp_ns)},
                               {"action", enumName(decision->action)},
                               {"experience", decision->experience},
                               {"template_id", decision->template_id},
                               {"confidence", decision->confidence}}));
  }
  if (decision != nullptr) {
    const std::int64_t frame = snapshot.frame->frame;
    for (const EarlierLoop& loop : decision->earlier) {
      messages.push_back(textOf(loopMessage(frame, loop.frame, loop.experience)));
    }
    if (decision->action == Action::CloseLoop) {
      messages.push_back(textOf(loopMessage(frame, frame, decision->experience)));
    }
  }
  if (snapshot.events == nullptr) return;
  for (const RunEvent& event : *snapshot.events) {
    Json json = {{"type", "event"}};
    json.update(Json(valueJson(event)));
    messages.push_back(textOf(json));
  }
}

}  // namespace tolman::web_viewer
