// SPDX-License-Identifier: BSD-3-Clause
// tolman plan: the fastest route between two places of a recorded map.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <optional>

#include "app/options.hpp"
#include "base/shortest_path.hpp"
#include "base/text_file.hpp"
#include "config/values.hpp"
#include "experiment/tables.hpp"
#include "record/export.hpp"
#include "record/run_reader.hpp"

namespace tolman::app {
namespace {

using experiment::Table;
using Json = Table::Json;

constexpr double kFarthest = 1e9;  // m; also the limit of positions in trajectory files

/// A run, with the reader of its record, and its map.
struct Map {
  std::unique_ptr<record::RunReader> reader;
  MapGraph graph;

  Eigen::Vector3d placeOf(std::int64_t experience) const {
    return planning::placeOf(graph.experiences[static_cast<std::size_t>(experience)]);
  }
};

/// Start or goal of the route: the text of the option, and the experience chosen for it.
struct End {
  std::string given;
  std::int64_t experience = -1;
  std::optional<double> away_m{};  ///< from a place to the experience; none for an experience
};

/// Parses "12.5,-30" or "12.5,-30,6": metres right, forward and up. Without a height, up is NaN.
/// Empty for any other text.
std::optional<Eigen::Vector3d> parsePlace(std::string_view text) {
  Eigen::Vector3d place(0, 0, std::numeric_limits<double>::quiet_NaN());
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = i < 2 ? text.find(',') : std::string_view::npos;
    const auto number = text_encoding::parseNumber(text.substr(0, comma));
    if (!number || std::abs(*number) > kFarthest) return {};
    place[i] = *number;
    if (comma == std::string_view::npos) return i > 0 ? std::optional(place) : std::nullopt;
    text.remove_prefix(comma + 1);
  }
  return {};
}

/// The experience nearest to a place, of the part of the map that `experience` is in; in its world
/// frame places are given, and the poses of the other parts in this frame are unknown.
End nearestTo(const Eigen::Vector3d& place, std::int64_t experience, const std::string& given,
              const Map& map) {
  MapGraph own = map.graph;
  const record::GraphParts parts = record::partsOf(own);
  const auto partOf = [&](std::int64_t id) {
    return parts.of_experience[static_cast<std::size_t>(id)];
  };
  std::erase_if(own.experiences,
                [&](const Experience& other) { return partOf(other.id) != partOf(experience); });
  const std::int64_t id = planning::nearestExperience(own, place);
  if (id < 0) return {given, id};  // the search reports that it is not in the map
  return {given, id, (map.placeOf(id) - place).head(std::isnan(place.z()) ? 2 : 3).norm()};
}

/// Where the robot was last: in a run that localises, at the experience that is nearest to its
/// pose; else at the newest one, during a run the last in the recorded graph.
End hereIn(const std::string& text, const Map& map) {
  if (valueOf(map.reader->localisedIn(), ExitCode::Dataset).empty()) {
    const auto newest = valueOf(map.reader->newestExperience(), ExitCode::Dataset);
    return {text, std::min(newest, std::ssize(map.graph.experiences) - 1)};
  }
  const auto answers = valueOf(map.reader->records<MapUpdate>(), ExitCode::Dataset);
  if (answers.empty() || answers.back().experience < 0) {
    fail(ExitCode::Dataset, map.reader->directory().string() +
                                ": its last place is unknown, so no route begins `here`");
  }
  const MapUpdate& last = answers.back();
  const Eigen::Vector3d place = planning::placeOf({.T_world_experience = last.T_world_camera});
  return nearestTo(place, last.experience, text, map);
}

/// Start or goal from the text of an option: "here", an experience ("17"), or a place in the first
/// part of the map.
End endOf(const std::string& text, const Map& map) {
  if (text == "here") return hereIn(text, map);
  if (const auto id = config::readInteger(text); id.isOk()) return {text, id.value()};
  const std::optional<Eigen::Vector3d> place = parsePlace(text);
  if (!place) {
    fail(ExitCode::Usage,
         "'" + text +
             "' is not a place: give an experience (17), `here`, or metres right, forward "
             "and, optionally, up from the start (12.5,-30,6), each at most 1e9");
  }
  return nearestTo(*place, 0, text, map);
}

/// The route for readers and programs. `unit`: "m", or "units" for the arbitrary ones of a single
/// camera.
Table tableOf(const planning::PlannedRoute& route, const std::array<End, 2>& ends, const Map& map,
              const std::string& unit) {
  Table table{{"experience", "right", "forward", "up", "time s", "path"}, {}};
  table.keys = {"experience", "right_m", "forward_m", "up_m", "seconds", "metres"};
  const auto timeText = [&](const planning::Leg& leg, int decimals) {
    return route.times_known ? fmt::format("{:.{}f}", leg.seconds, decimals) : "-";
  };
  for (const planning::Leg& leg : route.legs) {
    Eigen::Vector3d p = map.placeOf(leg.experience);
    const Json seconds = route.times_known ? Json(leg.seconds) : Json();
    table.values.push_back({leg.experience, p.x(), p.y(), p.z(), seconds, leg.metres});
    for (double& metres : p) metres = std::abs(metres) < 0.005 ? 0 : metres;  // no "-0.00"
    table.rows.push_back({std::to_string(leg.experience), fmt::format("{:.2f}", p.x()),
                          fmt::format("{:.2f}", p.y()), fmt::format("{:.2f}", p.z()),
                          timeText(leg, 2), fmt::format("{:.2f}", leg.metres)});
  }
  // Keys such as "metres" stay what readers know; "unit" is that of all lengths.
  table.about = {{"scale_known", unit == "m"},
                 {"unit", unit},
                 {"seconds", table.values.back()[4]},
                 {"metres", route.metres()}};
  const std::size_t count = route.legs.size();
  table.notes = {fmt::format("{} experience{}, {:.1f} {}, {} s", count, count == 1 ? "" : "s",
                             route.metres(), unit, timeText(route.legs.back(), 1))};
  if (!route.times_known) {
    table.notes.emplace_back(
        "times are not known, because no link of this map has a duration; this is the shortest "
        "route");
  }
  if (unit != "m") {
    table.notes.emplace_back(
        "lengths and places are in arbitrary units, because one camera cannot measure the scale");
  }
  for (const End& end : ends) {
    Json& json = table.about[&end == ends.data() ? "from" : "to"];
    json = {{"asked", end.given}, {"experience", end.experience}};
    if (!end.away_m) continue;
    json["away_m"] = *end.away_m;
    table.notes.push_back(fmt::format("{} is {:.1f} {} from experience {}, the nearest", end.given,
                                      *end.away_m, unit, end.experience));
  }
  return table;
}

struct RouteOptions {
  std::string run;
  std::string from;
  std::string to;
};

void plan(const RouteOptions& options, const Invocation& invocation) {
  Map map{valueOf(record::RunReader::open(options.run), ExitCode::Dataset), {}};
  map.graph = valueOf(map.reader->graph(), ExitCode::Dataset);
  const std::array<End, 2> ends = {endOf(options.from, map), endOf(options.to, map)};
  const bool in_metres = valueOf(map.reader->scaleKnown(), ExitCode::Dataset);
  const auto route = planning::fastestRoute(map.graph, ends[0].experience, ends[1].experience);
  const bool is_asked_wrongly = route.status().code() == StatusCode::InvalidInput;
  const Table table =
      tableOf(valueOf(route, is_asked_wrongly ? ExitCode::Usage : ExitCode::Dataset), ends, map,
              in_metres ? "m" : "units");
  std::cout << (invocation.json ? experiment::jsonOf(table) : experiment::textOf(table));
}

}  // namespace

void addPlanCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command = *app.add_subcommand("plan", "The fastest route between two places of a map");
  auto options = std::make_shared<RouteOptions>();
  addArgument(command, "run", options->run, "RUN", "Run directory");
  addArgument(command, "--from", options->from, "PLACE",
              "Start: an experience (17), a place in metres (12.5,-30), or `here`");
  addArgument(command, "--to", options->to, "PLACE", "Goal, given like --from");
  command.callback([options, &invocation] { plan(*options, invocation); });
}

}  // namespace tolman::app
