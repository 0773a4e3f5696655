// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/metrics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tolman/fields.hpp"

namespace tolman::evaluation {
namespace {

using Json = nlohmann::ordered_json;

Json sessionsJson(const Metrics& metrics) {
  Json json = Json::array();
  for (const SessionFigures& s : metrics.sessions) {
    json.push_back({{"name", s.name},
                    {"first_frame", s.first_frame},
                    {"frames", s.frames},
                    {"experiences", s.experiences},
                    {"parts", s.parts}});
  }
  return json;
}

Json timingJson(const std::map<std::string, StageTiming>& timing) {
  Json json = Json::object();
  for (const auto& [stage, t] : timing) json[stage] = toJson(t);
  return json;
}

}  // namespace

MapCounts countsOf(const MapGraph& graph, std::int64_t loop_decisions) {
  MapCounts counts;
  counts.experiences = static_cast<std::int64_t>(graph.experiences.size());
  counts.loop_decisions = loop_decisions;
  for (const Link& link : graph.links) {
    if (graph.isRejected(link)) {
      ++counts.rejected_loop_links;
      continue;
    }
    ++counts.links;
    if (link.kind == LinkKind::Loop) ++counts.loop_links;
  }
  return counts;
}

StageTiming stageTiming(const std::vector<std::int64_t>& durations_ns) {
  std::vector<double> ms;
  ms.reserve(durations_ns.size());
  for (const std::int64_t ns : durations_ns) ms.push_back(static_cast<double>(ns) * 1e-6);
  std::sort(ms.begin(), ms.end());
  const Statistics s = statistics(ms);
  const auto percentile = [&](std::size_t p) {
    return ms.empty() ? 0 : ms[(ms.size() - 1) * p / 100];
  };
  return {s.count, s.mean, s.median, percentile(90), percentile(95), s.max};
}

std::string unjoinedText(const Metrics& metrics) {
  if (metrics.parts <= 1) return "";
  std::vector<std::string> places;
  for (std::size_t i = 0; i < metrics.sessions.size(); ++i) {
    for (const std::int64_t part : metrics.sessions[i].parts) {
      places.push_back(fmt::format("session {} in part {}", i, part));
    }
  }
  return fmt::format(
      "the map is in {} parts that no link joins ({}); the relative poses of different parts are "
      "unknown",
      metrics.parts, fmt::join(places, ", "));
}

Json toJson(const StageTiming& timing) {
  return {{"frames", timing.frames}, {"mean_ms", timing.mean_ms}, {"median_ms", timing.median_ms},
          {"p90_ms", timing.p90_ms}, {"p95_ms", timing.p95_ms},   {"max_ms", timing.max_ms}};
}

Json toJson(const Metrics& metrics) {
  const bool known = metrics.odometry.scores && metrics.map.scores;
  Json coverage;
  if (known) coverage = std::min(metrics.odometry.scores->coverage, metrics.map.scores->coverage);
  Json json = {{"alignment", enumName(metrics.alignment)},
               {"odometry", toJson(metrics.odometry)},
               {"map", toJson(metrics.map)},
               {"nees", toJson(metrics.motions)},
               {"coverage", coverage},
               {"frames", metrics.frames},
               {"templates", metrics.templates},
               {"experiences", metrics.counts.experiences},
               {"links", metrics.counts.links},
               {"loop_links", metrics.counts.loop_links},
               {"rejected_loop_links", metrics.counts.rejected_loop_links},
               {"loop_decisions", metrics.counts.loop_decisions},
               {"loops", metrics.loops ? toJson(*metrics.loops) : Json()},
               {"truth_sha256", metrics.truth_sha256.empty() ? Json() : Json(metrics.truth_sha256)},
               {"parts", metrics.parts},
               {"sessions", sessionsJson(metrics)},
               {"cells", metrics.cells ? toJson(*metrics.cells) : Json()},
               {"timing", timingJson(metrics.timing)}};
  if (metrics.body) json["body"] = toJson(*metrics.body);
  if (!metrics.no_cells.empty()) json["cells_reason"] = metrics.no_cells;
  return json;
}

}  // namespace tolman::evaluation
