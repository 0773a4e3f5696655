// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/score.hpp"

#include <utility>

#include "evaluation/vertical.hpp"

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
  if (const std::string problem = upAxisProblem(pairs.truth); !problem.empty()) {
    scores.no_horizontal = scores.no_vertical = problem;
    return;
  }
  if (alignment != Alignment::None && (rollIsUnobservable(pairs) || rollIsContradicted(pairs))) {
    scores.no_horizontal = scores.no_vertical =
        "unknown, as this path is too straight to tell how the estimate is turned about it (or its "
        "orientations contradict its positions)";
    return;
  }
  scores.horizontal_m = absoluteError(pairs, Direction::Horizontal);
  scores.vertical_m = absoluteError(pairs, Direction::Vertical);
}

}  // namespace

TrajectoryMetrics score(const Trajectory& truth, const Trajectory& estimate, Alignment alignment,
                        const std::optional<SegmentLengths>& lengths,
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
  scores.rpe_frame = relativeErrorOverFrames(pairs);
  scores.rpe_metre = relativeErrorOverDistance(pairs);
  scores.kitti = segmentErrors(pairs, lengths.value_or(lengthsFor(pathLength(pairs.truth))));
  scores.scale = similarity.value().scale;
  metrics.path_length_m *= scores.scale;
  scores.coverage = pairs.coverage();
  return metrics;
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

}  // namespace tolman::evaluation
