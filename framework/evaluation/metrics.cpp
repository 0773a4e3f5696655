// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/metrics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "evaluation/recorded_cells.hpp"
#include "tolman/fields.hpp"

namespace tolman::evaluation {

namespace {

using Json = nlohmann::ordered_json;

Json textOrNone(const std::string& text) { return text.empty() ? Json() : Json(text); }

/// `json` has the members of the kind of population, and gets one for each score.
Json withScores(const PopulationFigures& of, Json json) {
  for (std::size_t i = 0; i < of.scores.kinds.size(); ++i) {
    Json& score = json[std::string(of.scores.kinds[i].key)];
    const auto& known = of.scores.scores[i];
    if (!known) continue;
    score = {{"median", known->median},
             {"chance", known->chance},
             {"shuffled_median", known->shuffled_median},
             {"share_above_chance", known->share_better}};
  }
  return json;
}

constexpr std::size_t kShuffles = 200;
/// Shortest shift (Boccara et al. 2010), but at most a tenth of the run.
constexpr double kMinShift = 20;  // s

std::vector<double> headingErrorsDeg(const PopulationHistory& ring, const StampedPoses& truth) {
  std::vector<double> errors;
  const ArrayAxis& axis = ring.info.axes[0];
  for (std::size_t i = 0; i < ring.frames.size(); ++i) {
    const auto at = truth.find(ring.frames[i]);
    const auto said = populationVector(
        std::vector<double>(ring.activity[i].begin(), ring.activity[i].end()), axis);
    if (!said || at == truth.end()) continue;
    const double heading = *said * 2 * std::numbers::pi / axis.period;
    errors.push_back(std::abs(wrapAngle(heading - at->second.pose.theta)) * kDegrees);
  }
  return errors;
}

/// Also sets figures.least_shift_s, the longest of all populations.
Shuffling shufflingOf(const RecordedUnits& units, CellFigures& figures) {
  const double least = std::min(kMinShift, units.seconds / 10);
  const double share = units.seconds > 0 ? least / units.seconds : 0.1;
  figures.least_shift_s = std::max(figures.least_shift_s, least);
  return {kShuffles,
          static_cast<std::size_t>(std::ceil(share * static_cast<double>(units.walk.size()))),
          figures.seed};
}

}  // namespace

Json toJson(const CellFigures& cells) {
  Json json{{"places", cells.truth ? "truth" : "map"},
            {"reason", textOrNone(cells.reason)},
            {"head_direction", Json::array()},
            {"grid", Json::array()},
            {"shuffles", cells.shuffles},
            {"least_shift_s", cells.least_shift_s},
            {"seed", cells.seed},
            {"occupancy_unit", "s"},
            {"speed_limit_m_s", cells.speed_limit}};
  for (const PopulationFigures& ring : cells.rings) {
    const Statistics& error = ring.error_deg;
    const auto known = [&](double value) { return error.count > 0 ? Json(value) : Json(); };
    json["head_direction"].push_back(withScores(ring, {{"array", ring.array},
                                                       {"units", ring.units},
                                                       {"error",
                                                        {{"median_deg", known(error.median)},
                                                         {"p90_deg", known(error.p90)},
                                                         {"frames", error.count}}}}));
  }
  for (const PopulationFigures& sheet : cells.sheets) {
    json["grid"].push_back(withScores(
        sheet, {{"array", sheet.array},
                {"units", sheet.units},
                {"period", sheet.period},
                {"period_unit", sheet.unit},
                {"rate_map",
                 {{"bin_m", sheet.scores.bin},
                  {"smoothing_m", sheet.scores.smoothing},
                  {"smoothed",
                   {"grid_score", "spacing", "orientation", "ellipticity", "border_score"}}}}}));
  }
  return json;
}

std::optional<CellFigures> scoreCells(const CellHistory& cells, const Trajectory& map,
                                      const Trajectory& truth, const TrajectoryMetrics& scored,
                                      std::uint64_t seed) {
  if (cells.rings.empty() && cells.sheets.empty()) return std::nullopt;
  CellFigures figures;
  figures.truth = scored.scores.has_value();
  figures.seed = seed;
  figures.shuffles = kShuffles;
  if (!figures.truth) figures.reason = scored.reason;
  const StampedPoses places = stampedPosesOf(figures.truth ? truth : map);
  for (const auto* list : {&cells.rings, &cells.sheets}) {
    for (const PopulationHistory& population : *list) {
      const bool is_ring = list == &cells.rings;
      const RecordedUnits units =
          unitsAt(population, places, measuredUnits(population), figures.truth);
      const Shuffling shuffling = shufflingOf(units, figures);
      const ArrayAxis& axis = population.info.axes[0];
      figures.speed_limit = units.speed_limit;
      PopulationFigures& of = (is_ring ? figures.rings : figures.sheets)
                                  .emplace_back(PopulationFigures{population.info.name,
                                                                  population.activity[0].size(),
                                                                  {},
                                                                  {},
                                                                  axis.period,
                                                                  axis.unit});
      of.scores = is_ring ? scoreRing(units, shuffling)
                          : scoreSheet(units, periodInMetres(population), shuffling);
      if (is_ring && figures.truth) of.error_deg = statistics(headingErrorsDeg(population, places));
    }
  }
  return figures;
}

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
  for (const std::int64_t ns : durations_ns) ms.push_back(static_cast<double>(ns) * 1e-6);
  std::ranges::sort(ms);
  const Statistics s = statistics(ms);
  const auto percentile = [&](std::size_t p) {
    return ms.empty() ? 0 : ms[(ms.size() - 1) * p / 100];
  };
  return {s.count, s.mean, s.median, percentile(90), percentile(95), s.max};
}

std::vector<std::string> verdictsOf(const Metrics& metrics) {
  constexpr double kStill = 0.1;   // m
  constexpr double kWorse = 1.02;  // of odometry's error; below, they are equal
  std::vector<std::string> verdicts;
  const auto& odometry = metrics.odometry;
  const auto& map = metrics.map;
  if (odometry.in_metres && metrics.frames > 1 && odometry.path_length_m < kStill) {
    verdicts.push_back(fmt::format(
        "the camera did not move, or no motion was found: the path of odometry is {:.3f} m",
        odometry.path_length_m));
  }
  const std::int64_t links = metrics.counts.loop_links;
  std::string loops = links == 0 ? "no loop was closed"
                                 : fmt::format("{} loop link{}", links, links == 1 ? "" : "s");
  if (metrics.loops && links > 0) {
    const LoopFigures& figures = *metrics.loops;
    loops += figures.false_links > 0  ? fmt::format(", {} of them FALSE", figures.false_links)
             : figures.true_links > 0 ? ", none of them false"
                                      : ", of places without true poses";
  }
  if (metrics.counts.rejected_loop_links > 0) {
    loops += fmt::format("; the map rejected {}", metrics.counts.rejected_loop_links);
  }
  if (metrics.localisation) {
    verdicts.push_back(localisationText(*metrics.localisation));
    return verdicts;
  }
  verdicts.push_back(loops);
  if (odometry.scores && map.scores) {
    const double before = odometry.scores->ate_m.rmse;
    const double after = map.scores->ate_m.rmse;
    if (after > kWorse * before) {
      verdicts.push_back(fmt::format(
          "the map is WORSE than its odometry: {:.3f} m against {:.3f} m", after, before));
    }
  }
  if (metrics.returns == false) {
    verdicts.emplace_back(
        "this recording never returns to a place: cells and map cannot be compared on it");
  }
  return verdicts;
}

std::string alignmentText(const Metrics& metrics) {
  const auto& scores = metrics.map.scores ? metrics.map.scores : metrics.odometry.scores;
  const bool fitted = metrics.alignment == Alignment::Sim3 && scores;
  return std::string(enumName(metrics.alignment)) +
         (fitted ? fmt::format(", scale {:.4g} fitted", scores->scale) : "");
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
  const auto& [odometry, map] = std::tie(metrics.odometry.scores, metrics.map.scores);
  Json sessions = Json::array(), timing = Json::object();
  for (const SessionFigures& s : metrics.sessions) {
    sessions.push_back({{"name", s.name},
                        {"first_frame", s.first_frame},
                        {"frames", s.frames},
                        {"experiences", s.experiences},
                        {"parts", s.parts}});
  }
  for (const auto& [stage, t] : metrics.timing) timing[stage] = toJson(t);
  Json json = {
      {"verdicts", verdictsOf(metrics)},
      {"alignment", enumName(metrics.alignment)},
      {"odometry", toJson(metrics.odometry)},
      {"map", toJson(metrics.map)},
      {"nees", toJson(metrics.motions)},
      {"coverage", odometry && map ? Json(std::min(odometry->coverage, map->coverage)) : Json()},
      {"returns", metrics.returns ? Json(*metrics.returns) : Json()},
      {"frames", metrics.frames},
      {"templates", metrics.templates},
      {"experiences", metrics.counts.experiences},
      {"links", metrics.counts.links},
      {"loop_links", metrics.counts.loop_links},
      {"rejected_loop_links", metrics.counts.rejected_loop_links},
      {"loop_decisions", metrics.counts.loop_decisions},
      {"loops", metrics.loops ? toJson(*metrics.loops) : Json()},
      {"truth_sha256", textOrNone(metrics.truth_sha256)},
      {"parts", metrics.parts},
      {"sessions", std::move(sessions)},
      {"cells", metrics.cells ? toJson(*metrics.cells) : Json()},
      {"timing", std::move(timing)}};
  if (metrics.body) json["body"] = toJson(*metrics.body);
  if (metrics.localisation) json["localisation"] = toJson(*metrics.localisation);
  return json;
}

}  // namespace tolman::evaluation
