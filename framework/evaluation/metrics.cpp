// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/metrics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "evaluation/axes_hint.hpp"
#include "evaluation/held_truth.hpp"
#include "evaluation/mirror_hint.hpp"
#include "evaluation/open_turn.hpp"
#include "evaluation/pose_reading.hpp"
#include "evaluation/rounded_truth.hpp"
#include "evaluation/session_frames.hpp"
#include "evaluation/truth_breaks.hpp"
#include "evaluation/turned_axes.hpp"
#include "tolman/fields.hpp"

namespace tolman::evaluation {
namespace {

using Json = nlohmann::ordered_json;

Json textOrNull(const std::string& text) { return text.empty() ? Json() : Json(text); }

/// Keys with a unit: {"rmse_m": ..., "mean_m": ...}; nulls where nothing was measured.
Json statisticsJson(const Statistics& s, const std::string& unit) {
  Json json;
  for (const auto& [key, value] :
       {std::pair("rmse", s.rmse), std::pair("mean", s.mean), std::pair("median", s.median),
        std::pair("min", s.min), std::pair("max", s.max)}) {
    json[std::string(key) + "_" + unit] = s.count > 0 ? Json(value) : Json();
  }
  return json;
}

Json positionsJson(const Statistics& errors_m, const std::string& reason = "") {
  Json json = statisticsJson(errors_m, "m");
  json["reason"] = textOrNull(reason);
  return json;
}

/// `why_none`: the reason where poses were compared and no pair was found.
Json relativeJson(const RelativeError& error, const std::string& translation_unit,
                  const std::string& rotation_unit, const std::string& why_none) {
  return {{"translation", statisticsJson(error.translation_m, translation_unit)},
          {"rotation", statisticsJson(error.rotation_deg, rotation_unit)},
          {"pairs", error.translation_m.count},
          {"reason", textOrNull(error.translation_m.count > 0 ? "" : why_none)}};
}

Json segmentsJson(const SegmentErrors& errors) {
  const bool known = errors.segments > 0;
  const bool asked = !errors.lengths.lengths_m.empty();
  return {{"t_rel_percent", known ? Json(errors.t_rel_percent) : Json()},
          {"r_rel_deg_per_100m", known ? Json(errors.r_rel_deg_per_100m) : Json()},
          {"lengths", asked ? Json(errors.lengths.name) : Json()},
          {"lengths_m", asked ? Json(errors.lengths.lengths_m) : Json()},
          {"segments", errors.segments},
          {"segments_in_gaps", errors.segments_in_gaps},
          {"reason", known || !asked ? Json()
                                     : Json(errors.segments_in_gaps > 0
                                                ? "all segments end where poses have no estimate, "
                                                  "in a gap of the truth, or in another "
                                                  "session, or are shorter than half of the way "
                                                  "between two frames"
                                                : "the path is shorter than any segment")}};
}

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

Result<Matches> associate(const Trajectory& truth, const Trajectory& estimate,
                          std::int64_t max_difference_ns) {
  if (truth.empty()) return Status::invalidInput("there is no ground truth");
  if (estimate.empty()) return Status::invalidInput("there is no estimate");
  return max_difference_ns < 0 ? associateByFrame(truth, estimate)
                               : associateByStamp(truth, estimate, max_difference_ns);
}

/// Both trajectories as seen from their first matched pose, as a run has its truth: so `horizontal`
/// is the plane of the first camera whatever the axes of the files' worlds are.
void referToFirst(Matches& matches) {
  for (Trajectory* trajectory : {&matches.truth, &matches.estimate}) {
    const Eigen::Isometry3d T_first_world = trajectory->front().T_world_camera.inverse();
    for (TrajectoryPose& pose : *trajectory) {
      pose.T_world_camera = T_first_world * pose.T_world_camera;
    }
  }
}

/// A warning of a truth that never moves: no alignment, drift or scale follows from it.
std::string stillHint(const Trajectory& truth) {
  constexpr double kStill = 1e-3;  // m; a standing camera's truth from any sensor wanders further
  const auto moves = [&](const TrajectoryPose& pose) {
    return (pose.T_world_camera.translation() - truth.front().T_world_camera.translation()).norm() >
           kStill;
  };
  if (truth.size() < 2 || std::ranges::any_of(truth, moves)) return "";
  return "the truth stands still: the figures say nothing about how well the path was followed; is "
         "this the right file, and are its columns right?";
}

/// Why the plane of the first camera cannot be that of the drive; empty if it can.
std::string planeProblem(const Trajectory& truth) {
  constexpr double kSteepest = 0.5;  // steeper than any road; ramps of car parks have 0.2
  Eigen::AlignedBox3d box;
  for (const TrajectoryPose& pose : truth) box.extend(pose.T_world_camera.translation());
  const Eigen::Vector3d size = box.sizes();
  const double width = std::hypot(size.x(), size.z());
  if (size.y() <= kSteepest * width) return "";
  return fmt::format(
      "se2 compares on the x-z plane of the first true pose (camera axes: x right, y down, z "
      "forward), but the truth moves {:.3g} m along that pose's y axis and only {:.3g} m in the "
      "plane; use se3, or give the truth as poses of a level camera",
      size.y(), width);
}

/// Why an alignment of these pairs would say nothing; empty if it can be done.
std::string whyNotAlignable(const Matches& pairs, Alignment alignment) {
  if (pairs.size() < 2 && alignment != Alignment::None) {
    return "only one pose matches; any one is aligned without an error, so give more";
  }
  if (pairs.size() < 3 && alignment == Alignment::Sim3) {
    return "only two poses match; any two are aligned with a free scale without an error, so give "
           "more";
  }
  return alignment == Alignment::Se2 ? planeProblem(pairs.truth) : "";
}

/// The whole position error, and its horizontal and vertical parts where they are determined.
void scorePositions(const Matches& pairs, Alignment alignment, Scores& scores) {
  if (alignment == Alignment::Se2) {
    scores.ate_m = scores.horizontal_m = absoluteError(pairs, Direction::Horizontal);
    scores.no_vertical = "se2 compares on the plane";
    return;
  }
  scores.ate_m = absoluteError(pairs);
  if (const std::string hint = upHint(pairs.truth); !hint.empty()) {
    scores.no_horizontal = scores.no_vertical = hint;
    return;
  }
  if (alignment != Alignment::None && (turnIsOpen(pairs) || turnIsContradicted(pairs))) {
    scores.no_horizontal = scores.no_vertical =
        "unknown, as this path is too straight to tell how the estimate is turned about it (or its "
        "orientations contradict its positions)";
    return;
  }
  scores.horizontal_m = absoluteError(pairs, Direction::Horizontal);
  scores.vertical_m = absoluteError(pairs, Direction::Vertical);
}

/// What is wrong with poses as they are read: before the world of inverted poses is moved.
std::string hintBefore(const Matches& matches, Alignment alignment) {
  std::string text = axesHint(matches);
  if (text.empty()) text = turnHint(matches);
  if (text.empty()) text = fixedOrientationHint(matches);
  if (text.empty()) text = poseReadingHint(matches);
  if (!text.empty() || alignment != Alignment::Se2) return text;
  text = upHint(matches.truth);
  if (!text.empty()) text += ", or use se3; se2 leaves y out";
  return text;
}

/// What is wrong with lengths and positions, which an alignment compares.
std::string hintAfter(const Matches& pairs, Alignment alignment) {
  std::string text = heldHint(pairs);
  if (text.empty()) text = constantCoordinateHint(pairs);
  if (text.empty()) text = standingHint(pairs);
  if (text.empty()) text = jumpHint(pairs);
  if (text.empty()) text = turnJumpHint(pairs);
  if (text.empty()) text = sessionFramesHint(pairs, alignment);
  if (text.empty()) text = lengthChangeHint(pairs);
  if (text.empty() && alignment != Alignment::Sim3) text = unitHint(pairs);
  if (text.empty() && alignment != Alignment::Sim3) text = scaleHint(pairs);
  if (text.empty()) text = speedHint(pairs);
  if (text.empty()) text = rotationHint(pairs);
  if (text.empty()) text = mirrorHint(pairs);
  if (text.empty()) text = turnedAxesHint(pairs);
  if (text.empty()) text = oppositeAxisHint(pairs);
  return text;
}

}  // namespace

TrajectoryMetrics scoreTrajectory(const Trajectory& truth, const Trajectory& estimate,
                                  Alignment alignment, const std::optional<SegmentLengths>& lengths,
                                  std::int64_t max_difference_ns) {
  TrajectoryMetrics metrics;
  metrics.path_length_m = pathLength(estimate);
  metrics.poses = estimate.size();
  Result<Matches> matches = associate(truth, estimate, max_difference_ns);
  if (!matches.isOk()) {
    metrics.reason = matches.status().message();
    return metrics;
  }
  metrics.matched = matches.value().size();
  metrics.warning = stillHint(matches.value().truth);
  if (metrics.warning.empty()) metrics.warning = hintBefore(matches.value(), alignment);
  const Rounding rounding = roundingOf(matches.value().truth);
  if (alignment != Alignment::None) referToFirst(matches.value());
  metrics.reason = whyNotAlignable(matches.value(), alignment);
  if (!metrics.reason.empty()) return metrics;
  const Result<Similarity> similarity = align(matches.value(), alignment);
  if (!similarity.isOk()) {
    metrics.reason = similarity.status().message();
    return metrics;
  }
  const Matches pairs = aligned(matches.value(), similarity.value());
  Scores& scores = metrics.scores.emplace();
  scorePositions(pairs, alignment, scores);
  if (metrics.warning.empty()) metrics.warning = hintAfter(pairs, alignment);
  if (metrics.warning.empty()) metrics.warning = roundedHint(rounding, scores.ate_m.rmse);
  scores.rpe_frame = relativeErrorOverFrames(pairs);
  scores.rpe_metre = relativeErrorOverDistance(pairs);
  scores.kitti = segmentErrors(pairs, lengths.value_or(lengthsFor(pathLength(pairs.truth))));
  scores.scale = similarity.value().scale;
  metrics.path_length_m *= scores.scale;
  scores.coverage = pairs.coverage();
  return metrics;
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

Json toJson(const TrajectoryMetrics& metrics) {
  const bool known = metrics.scores.has_value();
  const Scores scores = metrics.scores.value_or(Scores{});
  const auto why = [known](const char* reason) { return std::string(known ? reason : ""); };
  const std::string none = known ? "" : metrics.reason;
  return {{"ate", positionsJson(scores.ate_m, none)},
          {"ate_horizontal", positionsJson(scores.horizontal_m, none + scores.no_horizontal)},
          {"ate_vertical", positionsJson(scores.vertical_m, none + scores.no_vertical)},
          {"rpe",
           {{"frame", relativeJson(scores.rpe_frame, "m", "deg",
                                   why("no two poses that match are one frame apart"))},
            {"metre", relativeJson(scores.rpe_metre, "m_per_m", "deg_per_m",
                                   why("the path is shorter than 1 m"))}}},
          {"kitti", segmentsJson(scores.kitti)},
          {"path_length_m", metrics.in_metres ? Json(metrics.path_length_m) : Json()},
          {"path_length_units", metrics.in_metres ? Json() : Json(metrics.path_length_m)},
          {"poses", metrics.poses},
          {"matched", metrics.matched},
          {"coverage", known ? Json(scores.coverage) : Json()},
          {"scale", known ? Json(scores.scale) : Json()},
          {"reason", known ? Json() : Json(metrics.reason)},
          {"warning", textOrNull(metrics.warning)}};
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
  if (!metrics.no_cells.empty()) json["cells_reason"] = metrics.no_cells;
  return json;
}

}  // namespace tolman::evaluation
