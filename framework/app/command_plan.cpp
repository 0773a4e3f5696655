// SPDX-License-Identifier: BSD-3-Clause
// tolman plan: the fastest way between two places of a recorded map.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/exit_code.hpp"
#include "app/program.hpp"
#include "planning/shortest_path.hpp"
#include "record/graph_parts.hpp"
#include "record/run_reader.hpp"

namespace tolman::app {
namespace {

struct PlanOptions {
  std::string run;
  std::string from;
  std::string to;
};

template <class T>
bool parse(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// Metres are of the world of the map's first part; other parts lie nobody knows where.
MapGraph firstPart(MapGraph graph) {
  const record::GraphParts parts = record::partsOf(graph);
  std::erase_if(graph.experiences, [&](const Experience& experience) {
    return parts.of_experience[static_cast<std::size_t>(experience.id)] != 0;
  });
  return graph;
}

/// "17", or "12.5,-30": the experience nearest to metres right and forward.
Result<std::int64_t> experienceOf(const std::string& text, const MapGraph& graph) {
  std::int64_t id = -1;
  if (parse(text, id)) return id;
  const std::size_t comma = text.find(',');
  Eigen::Vector2d place;
  const std::string_view all = text;
  if (comma == std::string::npos || !parse(all.substr(0, comma), place.x()) ||
      !parse(all.substr(comma + 1), place.y()) || !place.allFinite()) {
    return Status::invalidParameter("'" + text +
                                    "' is no place: give an experience (17) or metres right and "
                                    "forward of the start (12.5,-30)");
  }
  return planning::nearestExperience(firstPart(graph), place);
}

void print(const planning::Route& route, const MapGraph& graph, bool json) {
  nlohmann::ordered_json legs = nlohmann::ordered_json::array();
  if (!json)
    std::cout << fmt::format("{:>10} {:>9} {:>9} {:>9} {:>9}\n", "experience", "right m",
                             "forward m", "time s", "way m");
  for (const planning::Leg& leg : route.legs) {
    const Eigen::Vector3d p = graph.experiences[static_cast<std::size_t>(leg.experience)]
                                  .T_world_experience.translation();
    if (json) {
      legs.push_back({{"experience", leg.experience},
                      {"right_m", p.x()},
                      {"forward_m", p.z()},
                      {"seconds", leg.seconds},
                      {"metres", leg.metres}});
    } else {
      std::cout << fmt::format("{:>10} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f}\n", leg.experience,
                               p.x(), p.z(), leg.seconds, leg.metres);
    }
  }
  if (!json) {
    std::cout << fmt::format("{} experiences, {:.1f} m, {:.1f} s\n", route.legs.size(),
                             route.metres(), route.seconds());
    return;
  }
  const nlohmann::ordered_json all = {
      {"seconds", route.seconds()}, {"metres", route.metres()}, {"legs", legs}};
  std::cout << all.dump(2) << "\n";
}

Result<planning::Route> plan(const PlanOptions& options, const MapGraph& graph) {
  const auto from = experienceOf(options.from, graph);
  if (!from.isOk()) return from.status();
  const auto to = experienceOf(options.to, graph);
  if (!to.isOk()) return to.status();
  return planning::fastestRoute(graph, from.value(), to.value());
}

void run(const PlanOptions& options, Invocation& invocation) {
  const auto fail = [&](ExitCode code, const Status& status) {
    std::cerr << status.message() << "\n";
    invocation.exit_code = static_cast<int>(code);
  };
  const auto reader = record::RunReader::open(options.run);
  if (!reader.isOk()) return fail(ExitCode::Dataset, reader.status());
  const auto& graph = reader.value()->graph();
  if (!graph.isOk()) return fail(ExitCode::Dataset, graph.status());
  const auto route = plan(options, graph.value());
  if (!route.isOk()) return fail(ExitCode::Usage, route.status());
  print(route.value(), graph.value(), invocation.json);
}

}  // namespace

void addPlanCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("plan", "The fastest way between two places of a map");
  auto options = std::make_shared<PlanOptions>();
  command->add_option("run", options->run, "Run directory")->required();
  command->add_option("--from", options->from, "Experience (17), or place in metres (12.5,-30)")
      ->required();
  command->add_option("--to", options->to, "The same")->required();
  command->callback([options, &invocation] { run(*options, invocation); });
}

}  // namespace tolman::app
