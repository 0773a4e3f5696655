// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/score.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "evaluation/trajectory.hpp"

namespace tolman::evaluation {

namespace {

using Points = Eigen::Matrix3Xd;

constexpr double kRounding = 1e-12;  // share of the path's extent below which errors are rounding
constexpr double kSameError = 1.05;
constexpr double kMovedShare = 0.1;  // of the squared error
// Between the alignment and the orientations: a sixth of the vertical error then counts as
// horizontal. Chosen on the clip of KITTI 06: two estimates of 250 and 281 frames had 7 and 8
// degrees.
constexpr double kTilted = 10 * std::numbers::pi / 180;
// Of the true path: such an error is that of an ordinary estimate. Chosen, not tuned.
constexpr double kOrdinary = 0.01;
// Two drifts, such as one in height and one to the side, have a correlation of 0.94 and more by
// chance where an alignment reduces the error to a third by one turn. Reasoned, not tuned.
constexpr double kChance = 3;

/// The rotation, about any axis, that brings the estimated orientations nearest to the true ones.
Eigen::Matrix3d turnToOrientations(const Matches& aligned) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < aligned.truth.size(); ++i) {
    sum += aligned.truth[i].T_world_camera.linear() *
           aligned.estimate[i].T_world_camera.linear().transpose();
  }
  return Eigen::Affine3d(sum).rotation();
}

/// The part of a rotation that is about `axis`.
Eigen::Matrix3d twist(const Eigen::Matrix3d& turn, const Eigen::Vector3d& axis) {
  const Eigen::Quaterniond q(turn);
  const double angle = 2 * std::atan2(q.vec().dot(axis), q.w());
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

}  // namespace

std::string upAxisProblem(const Trajectory& truth) {
  constexpr double kAlongX = 0.9;  // of the path; chosen, not tuned
  constexpr double kMoreY = 2;     // extent along y over that along z; chosen, not tuned
  if (truth.empty()) return "";
  double length = 0, along_x = 0;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const Eigen::Vector3d step =
        (truth[i - 1].T_world_camera.inverse() * truth[i].T_world_camera).translation();
    length += step.norm();
    along_x += std::fabs(step.x());
  }
  const Eigen::Vector3d size = extentFromFirst(truth);
  if (!(along_x > kAlongX * length) || !(size.y() > kMoreY * size.z())) return "";
  return fmt::format(
      "the true poses move along their own x axis, and more along the y axis of the first one "
      "({:.3g} m) than along its z axis ({:.3g} m), as poses with x forward and z up do, and y is "
      "taken as down: give poses of the camera (x right, y down, z forward)",
      size.y(), size.z());
}

namespace {

/// Why the x-z plane of the first pose cannot be that of the drive; empty if it can.
std::string planeProblem(const Trajectory& truth) {
  constexpr double kSteepest = 0.5;  // steeper than any road; ramps of car parks have 0.2
  const Eigen::Vector3d size = extentFromFirst(truth);
  const double width = std::hypot(size.x(), size.z());
  if (size.y() <= kSteepest * width) return "";
  return fmt::format(
      "se2 compares on the x-z plane of the first true pose (camera axes: x right, y down, z "
      "forward), but the truth moves {:.3g} m along that pose's y axis and only {:.3g} m in the "
      "plane; use se3, or give the truth as poses of a level camera",
      size.y(), width);
}

/// Whether horizontal and vertical errors may be swapped, because other turns of the estimate about
/// its mean position fit the truth as well. Either positions leave the roll open: a quarter turn
/// about a principal direction of the truth increases the root mean square error by less than 5 %,
/// and turns about it move more than a tenth of the squared error into or out of the vertical. Or
/// orientations contradict the alignment, and positions do not refute them: the turn that brings
/// the estimated orientations nearest to the true ones, or its part about a principal direction,
/// tilts the vertical (y) by more than 10 degrees, and leaves at most three times the error, or
/// less than 1 % of the true path.
bool rollIsOpen(const Matches& aligned) {
  const Points truth = centredPositions(aligned.truth);
  const Points estimate = centredPositions(aligned.estimate);
  const auto errorAfter = [&](const Eigen::Matrix3d& turn) -> Eigen::Vector3d {
    return (truth - turn * estimate).rowwise().squaredNorm();
  };
  const Eigen::Vector3d now = errorAfter(Eigen::Matrix3d::Identity());
  const double ordinary = kOrdinary * pathLength(aligned.truth);
  const double accepted = std::max(kChance * kChance * now.sum(),
                                   ordinary * ordinary * static_cast<double>(truth.cols()));
  const auto contradicts = [&](const Eigen::Matrix3d& turn) {
    return turn(1, 1) < std::cos(kTilted) && errorAfter(turn).sum() <= accepted;
  };
  const bool is_perfect = now.sum() <= kRounding * kRounding * truth.squaredNorm();
  const Eigen::Matrix3d whole = turnToOrientations(aligned);
  if (contradicts(whole)) return true;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(truth * truth.transpose());
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = principal.eigenvectors().col(i);
    if (contradicts(twist(whole, axis))) return true;
    bool quarter_is_free = false, moves = false;
    for (int eighths = 1; eighths < 8; ++eighths) {
      const Eigen::Vector3d turned =
          errorAfter(Eigen::AngleAxisd(eighths * std::numbers::pi / 4, axis).toRotationMatrix());
      const bool is_quarter = eighths == 2 || eighths == 6;
      quarter_is_free |= is_quarter && turned.sum() < kSameError * kSameError * now.sum();
      moves |= std::abs(turned.y() - now.y()) > kMovedShare * now.sum();
    }
    if (!is_perfect && quarter_is_free && moves) return true;
  }
  return false;
}

using Json = nlohmann::ordered_json;

Json orNull(const std::string& text) { return text.empty() ? Json() : Json(text); }

/// Keys with a unit: {"rmse_m": ..., "mean_m": ...}; nulls where nothing was measured.
Json statisticsJson(const Statistics& s, const std::string& unit) {
  Json json;
  for (const auto& [key, value] :
       {std::pair("rmse_", s.rmse), std::pair("mean_", s.mean), std::pair("median_", s.median),
        std::pair("min_", s.min), std::pair("max_", s.max)}) {
    json[key + unit] = s.count > 0 ? Json(value) : Json();
  }
  return json;
}

Json positionsJson(const Statistics& errors_m, const std::string& reason) {
  Json json = statisticsJson(errors_m, "m");
  json["reason"] = orNull(reason);
  return json;
}

/// `why_none`: the reason where no pair was found; empty where no poses were compared.
Json relativeJson(const RelativeError& error, const std::string& per, const std::string& why_none) {
  const std::size_t pairs = error.translation_m.count;
  return {{"translation", statisticsJson(error.translation_m, "m" + per)},
          {"rotation", statisticsJson(error.rotation_deg, "deg" + per)},
          {"pairs", pairs},
          {"reason", orNull(pairs > 0 ? "" : why_none)}};
}

Json segmentsJson(const SegmentErrors& errors) {
  const bool known = errors.segments > 0;
  const bool asked = !errors.lengths.lengths_m.empty();
  const char* why = known || !asked ? ""
                    : errors.segments_in_gaps > 0
                        ? "all segments end where poses have no estimate, in a gap of the truth, "
                          "or in another session, or are shorter than half of the way between two "
                          "frames"
                        : "the path is shorter than any segment";
  return {{"t_rel_percent", known ? Json(errors.t_rel_percent) : Json()},
          {"r_rel_deg_per_100m", known ? Json(errors.r_rel_deg_per_100m) : Json()},
          {"lengths", asked ? Json(errors.lengths.name) : Json()},
          {"lengths_m", asked ? Json(errors.lengths.lengths_m) : Json()},
          {"segments", errors.segments},
          {"segments_in_gaps", errors.segments_in_gaps},
          {"reason", orNull(why)}};
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
  if (hasPositionsAlone(pairs)) {
    scores.no_horizontal = scores.no_vertical =
        "the truth has positions alone, which do not say what is down";
    return;
  }
  if (const std::string problem = upAxisProblem(pairs.truth); !problem.empty()) {
    scores.no_horizontal = scores.no_vertical = problem;
    return;
  }
  if (alignment != Alignment::None && rollIsOpen(pairs)) {
    scores.no_horizontal = scores.no_vertical =
        "unknown, as this path is too straight to tell how the estimate is turned about it (or its "
        "orientations contradict its positions)";
    return;
  }
  scores.horizontal_m = absoluteError(pairs, Direction::Horizontal);
  scores.vertical_m = absoluteError(pairs, Direction::Vertical);
}

/// Relative errors, and those of orientations; none of them where the truth has positions alone.
void scoreMotions(const Matches& pairs, const Trajectory& truth, const Protocol& protocol,
                  Scores& scores) {
  const auto lengths = protocol.lengths.value_or(lengthsFor(pathLength(pairs.truth)));
  scores.kitti.lengths = lengths;
  scores.steps.resize(protocol.steps.size());
  if (hasPositionsAlone(pairs)) return;
  scores.rotation_deg = statistics(rotationErrors(pairs));
  scores.rpe_frame = relativeError(pairs, {});
  scores.rpe_metre = relativeError(pairs, {.unit = StepUnit::Metres, .divided = true});
  scores.kitti = segmentErrors(pairs, lengths, protocol.whole_segments ? &truth : nullptr,
                               protocol.single_precision);
  std::ranges::transform(protocol.steps, scores.steps.begin(),
                         [&](const Steps& steps) { return relativeError(pairs, steps); });
}

}  // namespace

bool hasPositionsAlone(const Matches& pairs) {
  constexpr double kTurns = 5;  // degrees
  if (hasOrientations(pairs.truth)) return false;
  Matches turns = pairs;
  for (TrajectoryPose& pose : turns.truth) pose = pairs.estimate.front();
  return std::ranges::any_of(rotationErrors(turns), [](double angle) { return angle > kTurns; });
}

std::string textOf(const Steps& steps) {
  constexpr std::array kUnits = {" frames", " poses", " s", " m", " deg"};
  return fmt::format("{:g}{}{}", steps.length, kUnits[static_cast<std::size_t>(steps.unit)],
                     steps.all ? "" : ", consecutive");
}

Protocol protocolOf(Habit habit, const Trajectory& truth, const Trajectory& estimate,
                    std::vector<Steps> steps) {
  Protocol protocol;
  const std::int64_t usual_ns = usualDifference(truth, estimate);
  const bool by_time = hasStamps(truth) && hasStamps(estimate);
  const auto match = [&](MatchRule rule, std::int64_t limit_ns) {
    if (by_time) protocol.matching = {rule, limit_ns};
  };
  const bool kitti = readsMatrices(habit);
  const bool exact = habit == Habit::Tolman || kitti;
  if (exact && usual_ns >= 0) match(MatchRule::Nearest, usual_ns);
  if (habit == Habit::Evo) match(MatchRule::Shorter, 10'000'000);
  if (habit == Habit::Rpg) match(MatchRule::Nearest, 20'000'000);
  if (habit == Habit::Tum) {  // its two programs match in two ways
    match(MatchRule::Nearest, 20'000'000);
    if (!steps.empty()) match(MatchRule::Each, 2 * medianStep(truth) - 1);
  }
  protocol.alignment.kind = kitti                 ? Alignment::Origin
                            : habit == Habit::Evo ? Alignment::None
                                                  : Alignment::Se3;
  if (habit == Habit::Rpg) protocol.alignment.vertical = Eigen::Vector3d::UnitZ();
  if (kitti) protocol.lengths = kittiLengths();
  protocol.whole_segments = kitti;
  protocol.single_precision = habit == Habit::Devkit;
  for (Steps& each : steps) {
    each.as_written = kitti;
    if (exact) continue;
    each.of_truth = habit == Habit::Rpg;
    each.over_gaps = true;
    each.end = habit == Habit::Tum ? StepEnd::Closest : StepEnd::Tenth;
    each.in_end_frame = habit == Habit::Tum;
    if (each.unit == StepUnit::Frames) each.unit = StepUnit::Poses;
  }
  protocol.steps = std::move(steps);
  return protocol;
}

std::vector<double> positionErrors(const Scores& scores) {
  const bool is_planar = scores.alignment.kind == Alignment::Se2;
  return positionErrors(scores.pairs, is_planar ? Direction::Horizontal : Direction::All);
}

TrajectoryMetrics score(const Trajectory& truth, const Trajectory& estimate,
                        const Protocol& protocol) {
  TrajectoryMetrics metrics;
  metrics.path_length_m = pathLength(estimate);
  metrics.poses = estimate.size();
  Result<Matches> found = associate(truth, estimate, protocol.matching);
  if (!found.isOk()) {
    metrics.reason = found.status().message();
    return metrics;
  }
  Matches matches = std::move(found).value();
  metrics.matched = matches.size();
  const AlignmentRule& rule = protocol.alignment;
  // Seen from the first matched pose, as a run has its truth, y is down whatever the worlds are.
  const bool by_world = rule.kind == Alignment::None || rule.vertical.y() == 0;
  Eigen::Isometry3d T_first_truth = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_first_estimate = T_first_truth;
  if (!by_world) {
    T_first_truth = matches.truth.front().T_world_camera.inverse();
    T_first_estimate = matches.estimate.front().T_world_camera.inverse();
    matches.truth = movedBy(T_first_truth, std::move(matches.truth));
    matches.estimate = movedBy(T_first_estimate, std::move(matches.estimate));
    if (matches.after) matches.after = movedBy(T_first_estimate, {*matches.after}).front();
  }
  metrics.reason = whyNotAlignable(matches, rule.kind);
  if (!metrics.reason.empty()) return metrics;
  const Result<Similarity> similarity = align(matches, rule);
  if (!similarity.isOk()) {
    metrics.reason = similarity.status().message();
    return metrics;
  }
  Scores& scores = metrics.scores.emplace();
  const Matches& pairs = scores.pairs = aligned(matches, similarity.value());
  scores.alignment = rule;
  scores.scale = similarity.value().scale;
  metrics.path_length_m *= scores.scale;
  scores.coverage = pairs.coverage();
  scorePositions(pairs, rule.kind, scores);
  scoreMotions(pairs, truth, protocol, scores);
  if (protocol.without_time) {
    Trajectory path = movedBy(T_first_estimate, estimate);
    for (auto& pose : path) pose.T_world_camera = similarity.value().apply(pose.T_world_camera);
    scores.path = pathDistance(movedBy(T_first_truth, truth), path);
  }
  return metrics;
}

Json detailsJson(const Scores& scores, const std::vector<Steps>& steps) {
  Json json = {{"rotation", statisticsJson(scores.rotation_deg, "deg")}};
  Json& list = json["steps"] = Json::array();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const RelativeError& error = scores.steps[i];
    list.push_back({{"step", textOf(steps[i])},
                    {"pairs", error.translation_m.count},
                    {"translation", statisticsJson(error.translation_m, "m")},
                    {"rotation", statisticsJson(error.rotation_deg, "deg")},
                    {"length", statisticsJson(error.length_m, "m")},
                    {"length_share", statisticsJson(error.length_percent, "percent")}});
  }
  Json& table = json["segments"] = Json::array();
  for (const SegmentMean& mean : scores.kitti.table) {
    if (mean.segments == 0) continue;
    table.push_back({{"length_m", mean.length_m},
                     {"segments", mean.segments},
                     {"t_rel_percent", mean.t_rel_percent},
                     {"r_rel_deg_per_100m", mean.r_rel_deg_per_100m}});
  }
  if (scores.path) {
    json["path"] = {{"hausdorff_m", scores.path->hausdorff_m},
                    {"to_truth", statisticsJson(scores.path->to_truth_m, "m")}};
  }
  return json;
}

Json toJson(const TrajectoryMetrics& metrics) {
  const bool known = metrics.scores.has_value();
  const Scores scores = metrics.scores.value_or(Scores{});
  const std::string none = known ? "" : metrics.reason;
  const auto lengthIf = [&](bool is) { return is ? Json(metrics.path_length_m) : Json(); };
  return {{"ate", positionsJson(scores.ate_m, none)},
          {"ate_horizontal", positionsJson(scores.horizontal_m, none + scores.no_horizontal)},
          {"ate_vertical", positionsJson(scores.vertical_m, none + scores.no_vertical)},
          {"rpe",
           {{"frame", relativeJson(scores.rpe_frame, "",
                                   known ? "no two poses that match are one frame apart" : "")},
            {"metre", relativeJson(scores.rpe_metre, "_per_m",
                                   known ? "the path is shorter than 1 m" : "")}}},
          {"kitti", segmentsJson(scores.kitti)},
          {"path_length_m", lengthIf(metrics.in_metres)},
          {"path_length_units", lengthIf(!metrics.in_metres)},
          {"poses", metrics.poses},
          {"matched", metrics.matched},
          {"coverage", known ? Json(scores.coverage) : Json()},
          {"scale", known ? Json(scores.scale) : Json()},
          {"reason", orNull(none)},
          {"warning", orNull(metrics.warning)}};
}

}  // namespace tolman::evaluation
