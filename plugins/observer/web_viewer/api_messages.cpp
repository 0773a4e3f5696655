// SPDX-License-Identifier: BSD-3-Clause
#include "api_messages.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "base/shortest_path.hpp"
#include "frame_encoder.hpp"
#include "http_connection.hpp"

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

// Routes through the present map.

namespace {

using Json = nlohmann::ordered_json;

constexpr double kFarthest = 1e9;  // m; the bound of all positions that are read
constexpr const char* kForm =
    "give to=17, an experience, or to=12.5,-30, metres right and forward of the start and, if you "
    "like, up; from= likewise, or from=here";

ApiAnswer problem(unsigned status, const std::string& text) {
  return {status, Json({{"error", text}}).dump(-1, ' ', false, Json::error_handler_t::replace)};
}

template <class T>
bool parse(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// An end of the route: where the robot is, an experience, or a place.
struct End {
  bool is_here = false;
  std::optional<std::int64_t> experience;
  Eigen::Vector3d place{0, 0, std::numeric_limits<double>::quiet_NaN()};
};

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

std::optional<End> parseEnd(std::string_view given) {
  const std::string plain = decodedValue(given);
  std::string_view text = trimmed(plain);
  End end;
  end.is_here = text == "here";
  if (end.is_here) return end;
  std::int64_t id = 0;
  if (parse(text, id)) {
    end.experience = id;
    return end;
  }
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = i < 2 ? text.find(',') : std::string_view::npos;
    double& metres = end.place[i];
    if (!parse(trimmed(text.substr(0, comma)), metres) || !(std::abs(metres) <= kFarthest))
      return {};
    if (comma == std::string_view::npos) return i > 0 ? std::optional(end) : std::nullopt;
    text.remove_prefix(comma + 1);
  }
  return {};
}

struct Query {
  std::optional<End> from = parseEnd("here");
  std::optional<End> to;
};

/// Empty for an unknown or repeated key, and for a value that is not an end.
std::optional<Query> parseQuery(std::string_view text) {
  Query query;
  std::set<std::string_view> seen;
  while (!text.empty()) {
    const std::string_view part = text.substr(0, text.find('&'));
    text.remove_prefix(std::min(text.size(), part.size() + 1));
    const std::size_t equals = part.find('=');
    const std::string_view key = part.substr(0, equals);
    if (equals == std::string_view::npos || (key != "from" && key != "to")) return {};
    if (!seen.insert(key).second) return {};
    (key == "from" ? query.from : query.to) = parseEnd(part.substr(equals + 1));
  }
  return query.from && query.to ? std::optional(query) : std::nullopt;
}

/// A graph with only the fields that planning uses.
MapGraph graphOf(const FlatGraph& flat) {
  MapGraph graph;
  graph.experiences.resize(flat.experience.size() / 4);
  for (std::size_t i = 0; i < graph.experiences.size(); ++i) {
    const float* e = flat.experience.data() + 4 * i;
    graph.experiences[i].id = static_cast<std::int64_t>(i);
    graph.experiences[i].T_world_experience.translation() << e[0], e[1], e[2];
  }
  graph.links.resize(flat.link_kind.size());
  for (std::size_t i = 0; i < graph.links.size(); ++i) {
    Link& link = graph.links[i];
    link.id = static_cast<std::int64_t>(i);
    link.from = flat.link[2 * i];
    link.to = flat.link[2 * i + 1];
    link.kind = static_cast<LinkKind>(flat.link_kind[i]);
    link.T_from_to.translation().x() = flat.link_metres[i];
    link.duration = flat.link_seconds[i];
    if (flat.link_rejected[i] != 0) graph.rejected.push_back(link.id);
  }
  return graph;
}

/// The experience of the robot. The graph may be some frames older than the pose, so its last
/// experience is the largest answer.
std::int64_t here(const MapGraph& graph, const LatestPose& pose) {
  return std::min(pose.experience, static_cast<std::int64_t>(graph.experiences.size()) - 1);
}

/// The experience of an end; -1 if there is none.
std::int64_t chosen(const End& end, const MapGraph& graph, const LatestPose& pose) {
  if (end.is_here) return here(graph, pose);
  if (end.experience) return *end.experience;
  return planning::nearestExperience(planning::connectedTo(graph, here(graph, pose)), end.place);
}

Json routeJson(const planning::PlannedRoute& route, const MapGraph& graph) {
  const auto seconds = [&](double value) { return route.times_known ? Json(value) : Json(); };
  Json legs = Json::array();
  for (const planning::Leg& leg : route.legs) {
    const auto& experience = graph.experiences[static_cast<std::size_t>(leg.experience)];
    const Eigen::Vector3d p = planning::placeOf(experience);
    legs.push_back({{"experience", leg.experience},
                    {"right_m", p.x()},
                    {"forward_m", p.y()},
                    {"up_m", p.z()},
                    {"seconds", seconds(leg.seconds)},
                    {"metres", leg.metres}});
  }
  return {
      {"seconds", seconds(route.seconds())}, {"metres", route.metres()}, {"legs", std::move(legs)}};
}

}  // namespace

ApiAnswer planAnswer(const FlatGraph& flat, const LatestPose& pose, std::string_view query) {
  const std::optional<Query> asked = parseQuery(query);
  if (!asked) return problem(400, kForm);
  const MapGraph graph = graphOf(flat);
  if (graph.experiences.empty()) return problem(404, "the map is empty so far");
  const std::int64_t from = chosen(*asked->from, graph, pose);
  const std::int64_t to = chosen(*asked->to, graph, pose);
  const auto route = planning::fastestRoute(graph, from, to);
  if (!route.isOk()) return problem(404, route.status().message());
  Json json = {{"frame", flat.header.frame}, {"from", from}, {"to", to}};
  json.update(routeJson(route.value(), graph));
  return {200, json.dump()};
}

}  // namespace tolman::web_viewer
