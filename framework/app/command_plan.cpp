// SPDX-License-Identifier: BSD-3-Clause
// tolman plan: the fastest route between two places of a recorded map.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <limits>
#include <optional>

#include "app/options.hpp"
#include "base/shortest_path.hpp"
#include "record/map_file.hpp"
#include "record/run_reader.hpp"

namespace tolman::app {
namespace {

constexpr double kFarthest = 1e9;  // m; also the limit of positions in trajectory files

struct RouteOptions {
  std::string run;
  std::string from;
  std::string to;
};

template <class T>
bool parse(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// The experiences of the first part of the map. Places are given in the world frame of this part;
/// the poses of the other parts in this frame are unknown.
MapGraph firstPart(MapGraph graph) {
  const record::GraphParts parts = record::partsOf(graph);
  std::erase_if(graph.experiences, [&](const Experience& experience) {
    return parts.of_experience[static_cast<std::size_t>(experience.id)] != 0;
  });
  return graph;
}

/// Start or goal of the route: the text of the option, and the experience chosen for it.
struct End {
  std::string given;
  std::int64_t experience = -1;
  std::optional<double> away_m;  ///< from a place to the experience; none for an experience
};

Eigen::Vector3d placeOf(std::int64_t experience, const MapGraph& graph) {
  return planning::placeOf(graph.experiences[static_cast<std::size_t>(experience)]);
}

/// Parses "12.5,-30" or "12.5,-30,6": metres right, forward and up. Without a height, up is NaN.
/// Empty for any other text.
std::optional<Eigen::Vector3d> parsePlace(std::string_view text) {
  Eigen::Vector3d place(0, 0, std::numeric_limits<double>::quiet_NaN());
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = i < 2 ? text.find(',') : std::string_view::npos;
    if (!parse(text.substr(0, comma), place[i]) || !(std::abs(place[i]) <= kFarthest)) return {};
    if (comma == std::string_view::npos) return i > 0 ? std::optional(place) : std::nullopt;
    text.remove_prefix(comma + 1);
  }
  return {};
}

/// The experience at which the robot is, or was at the end of the run. During a run the recorded
/// graph may not contain the newest experience yet; the last one in it is used then.
End endHere(const record::RunReader& reader, const MapGraph& graph) {
  const auto newest = valueOf(reader.newestExperience(), ExitCode::Dataset);
  const auto last = static_cast<std::int64_t>(graph.experiences.size()) - 1;
  return End{"here", std::min(newest, last), std::nullopt};
}

/// Start or goal from the text of an option: "here", an experience ("17"), or a place, for which
/// the nearest experience is taken.
End endOf(const std::string& text, const record::RunReader& reader, const MapGraph& graph) {
  if (text == "here") return endHere(reader, graph);
  std::int64_t id = -1;
  if (parse(text, id)) return End{text, id, std::nullopt};
  const std::optional<Eigen::Vector3d> place = parsePlace(text);
  if (!place) {
    fail(ExitCode::Usage,
         "'" + text +
             "' is not a place: give an experience (17), `here`, or metres right, forward "
             "and, optionally, up from the start (12.5,-30,6), each at most 1e9");
  }
  id = planning::nearestExperience(firstPart(graph), *place);
  if (id < 0) return End{text, id, std::nullopt};  // the search reports that it is not in the map
  const int dimensions = std::isnan(place->z()) ? 2 : 3;
  return End{text, id, (placeOf(id, graph) - *place).head(dimensions).norm()};
}

struct RoutePlan {
  End from;
  End to;
  bool scale_known = true;  ///< false (a single camera): lengths are in arbitrary units
  planning::PlannedRoute route;

  const char* unit() const { return scale_known ? "m" : "units"; }
  /// Null if no link has a duration.
  nlohmann::ordered_json secondsOf(const planning::Leg& leg) const {
    return route.times_known ? nlohmann::ordered_json(leg.seconds) : nullptr;
  }
  std::string timeText(const planning::Leg& leg, int decimals) const {
    return route.times_known ? fmt::format("{:.{}f}", leg.seconds, decimals) : "-";
  }
};

nlohmann::ordered_json toJson(const End& end) {
  nlohmann::ordered_json json = {{"asked", end.given}, {"experience", end.experience}};
  if (end.away_m) json["away_m"] = *end.away_m;
  return json;
}

nlohmann::ordered_json toJson(const RoutePlan& plan, const MapGraph& graph) {
  nlohmann::ordered_json legs = nlohmann::ordered_json::array();
  for (const planning::Leg& leg : plan.route.legs) {
    const Eigen::Vector3d p = placeOf(leg.experience, graph);
    legs.push_back({{"experience", leg.experience},
                    {"right_m", p.x()},
                    {"forward_m", p.y()},
                    {"up_m", p.z()},
                    {"seconds", plan.secondsOf(leg)},
                    {"metres", leg.metres}});
  }
  // Keys such as "metres" stay what readers know; "unit" is that of all lengths.
  return {{"from", toJson(plan.from)},
          {"to", toJson(plan.to)},
          {"scale_known", plan.scale_known},
          {"unit", plan.unit()},
          {"seconds", plan.secondsOf(plan.route.legs.back())},
          {"metres", plan.route.metres()},
          {"legs", legs}};
}

void print(const RoutePlan& plan, const MapGraph& graph) {
  const char* unit = plan.unit();
  std::cout << fmt::format("{:>10} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "experience", "right",
                           "forward", "up", "time s", "path");
  for (const planning::Leg& leg : plan.route.legs) {
    Eigen::Vector3d p = placeOf(leg.experience, graph);
    for (double& metres : p) metres = std::abs(metres) < 0.005 ? 0 : metres;  // no "-0.00"
    std::cout << fmt::format("{:>10} {:>9.2f} {:>9.2f} {:>9.2f} {:>9} {:>9.2f}\n", leg.experience,
                             p.x(), p.y(), p.z(), plan.timeText(leg, 2), leg.metres);
  }
  std::cout << fmt::format("{} experience{}, {:.1f} {}, {} s\n", plan.route.legs.size(),
                           plan.route.legs.size() == 1 ? "" : "s", plan.route.metres(), unit,
                           plan.timeText(plan.route.legs.back(), 1));
  if (!plan.route.times_known) {
    std::cout << "times are not known, because no link of this map has a duration; this is the "
                 "shortest route\n";
  }
  if (!plan.scale_known) {
    std::cout << "lengths and places are in arbitrary units, because one camera cannot measure the "
                 "scale\n";
  }
  for (const End& end : {plan.from, plan.to}) {
    if (end.away_m) {
      std::cout << fmt::format("{} is {:.1f} {} from experience {}, the nearest\n", end.given,
                               *end.away_m, unit, end.experience);
    }
  }
}

void run(const RouteOptions& options, const Invocation& invocation) {
  const auto reader = valueOf(record::RunReader::open(options.run), ExitCode::Dataset);
  const MapGraph graph = valueOf(reader->graph(), ExitCode::Dataset);
  RoutePlan plan{endOf(options.from, *reader, graph),
                 endOf(options.to, *reader, graph),
                 valueOf(reader->scaleKnown(), ExitCode::Dataset),
                 {}};
  const auto route = planning::fastestRoute(graph, plan.from.experience, plan.to.experience);
  const bool is_asked_wrongly = route.status().code() == StatusCode::InvalidInput;
  plan.route = valueOf(route, is_asked_wrongly ? ExitCode::Usage : ExitCode::Dataset);
  if (invocation.json) {
    std::cout << jsonText(toJson(plan, graph));
  } else {
    print(plan, graph);
  }
}

}  // namespace

void addPlanCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command = *app.add_subcommand("plan", "The fastest route between two places of a map");
  auto options = std::make_shared<RouteOptions>();
  addArgument(command, "run", options->run, "RUN", "Run directory");
  addArgument(command, "--from", options->from, "PLACE",
              "Start: an experience (17), a place in metres (12.5,-30), or `here`");
  addArgument(command, "--to", options->to, "PLACE", "Goal, given like --from");
  command.callback([options, &invocation] { run(*options, invocation); });
}

}  // namespace tolman::app
