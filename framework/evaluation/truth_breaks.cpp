// SPDX-License-Identifier: BSD-3-Clause
// The constants were chosen with KITTI 00 in view, and judged on 02, 05, 06, 07, the clips 01 and
// 06, TUM fr1/xyz and the town.
#include "evaluation/truth_breaks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "evaluation/truth_steps.hpp"
#include "evaluation/turns.hpp"

namespace tolman::evaluation {
namespace {

constexpr std::size_t kWindow = 5;  // steps over which displacements are compared

bool isTracked(const Matches& matches, std::size_t from, std::size_t to) {
  for (std::size_t i = from + 1; i <= to; ++i) {
    if (!isTrackedStep(matches, i)) return false;
  }
  return true;
}

/// The first stretch of `fewest` steps or more in which `still` moves by less than a tenth of what
/// `moving` does.
std::optional<Standing> standingStretch(const Matches& pairs, const Trajectory& still,
                                        const Trajectory& moving, std::size_t fewest) {
  constexpr double kStill = 0.1;
  constexpr double kUsualSpeed = 0.25;
  const double least = leastWay(pairs.truth);
  const double usual = usualStep(pairs.truth);
  const auto stands = [&](std::size_t i) {
    return isTracked(pairs, i - kWindow, i) && distanceBetween(still, i - kWindow, i) <
                                                   kStill * distanceBetween(moving, i - kWindow, i);
  };
  for (std::size_t i = kWindow; i < pairs.size(); ++i) {
    const std::size_t first = i - kWindow;
    while (i < pairs.size() && stands(i)) ++i;
    const Standing standing{first, i - 1, distanceBetween(moving, first, i - 1)};
    const std::size_t steps = standing.last - first;
    if (steps < fewest || standing.way < least) continue;
    if (standing.way > kUsualSpeed * usual * static_cast<double>(steps)) return standing;
  }
  return std::nullopt;
}

double turnAngle(const Trajectory& path, std::size_t i) {
  return turnBetween(path[i - 1], path[i]).norm();
}

/// The angle of each step of the truth, rad; 0 for the first pose.
std::vector<double> trueTurns(const Trajectory& truth) {
  std::vector<double> turns(truth.size());
  for (std::size_t i = 1; i < truth.size(); ++i) turns[i] = turnAngle(truth, i);
  return turns;
}

/// Whether the step `i` of the truth turns much more than the steps around it, `usual`, and the
/// estimate by `estimated`.
bool isTurnJump(const std::vector<double>& turns, std::size_t i, double usual, double estimated) {
  constexpr double kLeast = 3 * kDegree;
  constexpr double kTimes = 4;
  const double most =
      std::max({usual, estimated, turns[i - 2], turns[i - 1], turns[i + 1], turns[i + 2]});
  return turns[i] >= estimated + kLeast && turns[i] > kTimes * most;
}

/// The logarithm of estimated over true length of a part of the path that begins at `pair`.
struct Ratio {
  std::size_t pair = 0;
  double log = 0;
};

/// Of parts of equal numbers of steps, about forty, where they are not short.
std::vector<Ratio> ratiosOf(const Matches& pairs) {
  constexpr std::size_t kParts = 40;
  const std::size_t steps = std::max(kWindow, pairs.size() / kParts);
  const double short_step = 0.2 * usualStep(pairs.truth);
  std::vector<Ratio> ratios;
  for (std::size_t i = 0; i + steps < pairs.size(); i += steps) {
    const double truth = distanceBetween(pairs.truth, i, i + steps);
    const double estimate = distanceBetween(pairs.estimate, i, i + steps);
    const bool is_short = truth <= short_step * static_cast<double>(steps) || estimate == 0;
    if (is_short || !isTracked(pairs, i, i + steps)) continue;
    ratios.push_back({i, std::log(estimate / truth)});
  }
  return ratios;
}

struct Part {
  double mean = 0;
  double squares = 0;  ///< sum of the squared differences from the mean
};

Part partOf(const std::vector<Ratio>& ratios, std::size_t begin, std::size_t end) {
  Part part;
  const auto count = static_cast<double>(end - begin);
  for (std::size_t i = begin; i < end; ++i) part.mean += ratios[i].log / count;
  for (std::size_t i = begin; i < end; ++i) {
    part.squares += (ratios[i].log - part.mean) * (ratios[i].log - part.mean);
  }
  return part;
}

struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// How far the path goes along an axis of the world.
double extent(const Trajectory& path, int axis, const Stretch& part) {
  double least = path[part.first].T_world_camera.translation()[axis];
  double most = least;
  for (std::size_t i = part.first; i <= part.last; ++i) {
    const double at = path[i].T_world_camera.translation()[axis];
    least = std::min(least, at);
    most = std::max(most, at);
  }
  return most - least;
}

double largestExtent(const Trajectory& path, const Stretch& part) {
  return std::max({extent(path, 0, part), extent(path, 1, part), extent(path, 2, part)});
}

/// The longest stretch in which the truth has exactly one value along the axis.
Stretch constantStretch(const Trajectory& truth, int axis) {
  Stretch longest;
  for (std::size_t first = 0, i = 1; i <= truth.size(); ++i) {
    const auto at = [&](std::size_t k) { return truth[k].T_world_camera.translation()[axis]; };
    if (i < truth.size() && at(i) == at(first)) continue;
    if (i - 1 - first > longest.last - longest.first) longest = {first, i - 1};
    first = i;
  }
  return longest;
}

}  // namespace

std::string standingHint(const Matches& aligned) {
  constexpr std::size_t kTrueSteps = 10;
  // Rough maps draw frames together: those of RatSLAM up to 50, on KITTI 00 to 07, which
  // chose this. No alarm in the town, with the cells of RatSLAM and NeuroSLAM.
  constexpr std::size_t kEstimatedSteps = 100;
  const auto& [truth, estimate] = std::tie(aligned.truth, aligned.estimate);
  if (const auto found = standingStretch(aligned, truth, estimate, kTrueSteps)) {
    return standingText(*found, aligned, true, "almost still");
  }
  if (const auto found = standingStretch(aligned, estimate, truth, kEstimatedSteps)) {
    return standingText(*found, aligned, false, "almost still");
  }
  return "";
}

std::string turnJumpHint(const Matches& matches) {
  const std::vector<double> turns = trueTurns(matches.truth);
  double squares = 0;
  for (const double turn : turns) squares += turn * turn;
  const auto count = static_cast<double>(turns.size());
  for (std::size_t i = 3; i + 2 < matches.size(); ++i) {
    const double others = std::sqrt(std::max(0.0, squares - turns[i] * turns[i]) / count);
    const double estimated = turnAngle(matches.estimate, i);
    if (!isTurnJump(turns, i, others, estimated) || !isTracked(matches, i - 3, i + 2)) continue;
    return fmt::format(
        "the truth turns by {:.3g} degrees in one step, to frame {}, where the estimate turns by "
        "{:.3g}: are its parts of different drives, or its poses wrong? All errors are wrong if so",
        turns[i] / kDegree, matches.truth[i].frame, estimated / kDegree);
  }
  return "";
}

std::string constantCoordinateHint(const Matches& aligned) {
  constexpr std::size_t kFewest = 30;  // steps
  constexpr double kShare = 0.5;       // of the largest extent of the estimate
  constexpr double kShareOfAll = 0.1;  // of that of the whole truth: more than noise
  const double whole = largestExtent(aligned.truth, {0, aligned.size() - 1});
  for (int axis = 0; axis < 3; ++axis) {
    const Stretch part = constantStretch(aligned.truth, axis);
    if (part.last - part.first < kFewest) continue;
    const double moved = extent(aligned.estimate, axis, part);
    const double least = std::max(leastWay(aligned.truth), kShareOfAll * whole);
    if (moved < least || moved < kShare * largestExtent(aligned.estimate, part)) continue;
    return fmt::format(
        "the truth has exactly one value of {} from frame {} to {}, where the estimate moves "
        "{:.3g} m along it: is a column missing? All errors are wrong if so",
        "xyz"[axis], aligned.truth[part.first].frame, aligned.truth[part.last].frame, moved);
  }
  return "";
}

std::string lengthChangeHint(const Matches& aligned) {
  constexpr std::size_t kFewest = 4;   // parts before and after
  const double least = std::log(1.5);  // other units differ by more, and yards from metres less
  constexpr double kDeviations = 6;    // a ratio that grows evenly has 3.5
  const std::vector<Ratio> ratios = ratiosOf(aligned);
  std::size_t best = 0;
  Part before, after;
  for (std::size_t i = kFewest; i + kFewest <= ratios.size(); ++i) {
    const Part left = partOf(ratios, 0, i);
    const Part right = partOf(ratios, i, ratios.size());
    if (best > 0 && left.squares + right.squares >= before.squares + after.squares) continue;
    best = i;
    before = left;
    after = right;
  }
  const double change = std::fabs(after.mean - before.mean);
  const double variance = (before.squares + after.squares) /
                          static_cast<double>(std::max<std::size_t>(1, ratios.size()));
  if (best == 0 || change < least || change < kDeviations * std::sqrt(variance)) return "";
  return fmt::format(
      "the estimate is {:.3g} times as long as the truth until frame {}, and {:.3g} times from "
      "there on: does the truth change its unit, or the estimate its scale? All errors are wrong "
      "if so",
      std::exp(before.mean), aligned.truth[ratios[best].pair].frame, std::exp(after.mean));
}

}  // namespace tolman::evaluation
