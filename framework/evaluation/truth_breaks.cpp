// SPDX-License-Identifier: BSD-3-Clause
// The constants were chosen with KITTI 00 in view, and judged on other sequences.
#include "evaluation/truth_breaks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>
#include <vector>

#include "evaluation/truth_steps.hpp"
#include "evaluation/turns.hpp"

namespace tolman::evaluation {
namespace {

constexpr std::size_t kWindow = 5;  // steps over which displacements are compared
constexpr double kRadiansPerDegree = std::numbers::pi / 180;

bool isTracked(const Matches& matches, std::size_t from, std::size_t to) {
  for (std::size_t i = from + 1; i <= to; ++i) {
    if (!isTrackedStep(matches, i)) return false;
  }
  return true;
}

struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// The first stretch in which `still` moves by less than a tenth of what `moving` does.
std::optional<Stretch> standingStretch(const Matches& pairs, const Trajectory& still,
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
    const Stretch stretch{first, i - 1};
    if (stretch.last < stretch.first + fewest) continue;
    const double way = distanceBetween(moving, stretch.first, stretch.last);
    const auto steps = static_cast<double>(stretch.last - stretch.first);
    if (way >= least && way > kUsualSpeed * usual * steps) return stretch;
  }
  return std::nullopt;
}

std::string standingText(const Matches& pairs, const Stretch& stretch, const char* still,
                         const char* moves, double way) {
  return fmt::format(
      "the {} stands almost still from frame {} to {} while the {} moves {:.3g} m: ", still,
      pairs.truth[stretch.first].frame, pairs.truth[stretch.last].frame, moves, way);
}

double turnAngle(const Trajectory& path, std::size_t i) {
  return turnBetween(path[i - 1], path[i]).norm();
}

bool isTurnJump(const Matches& matches, std::size_t i, double usual) {
  constexpr double kLeast = 3 * kRadiansPerDegree;
  constexpr double kTimes = 4;
  const double turn = turnAngle(matches.truth, i);
  const double estimated = turnAngle(matches.estimate, i);
  if (turn < estimated + kLeast) return false;
  double most = std::max(usual, estimated);
  for (const std::size_t near : {i - 2, i - 1, i + 1, i + 2}) {
    most = std::max(most, turnAngle(matches.truth, near));
  }
  return turn > kTimes * most && isTracked(matches, i - 3, i + 2);
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
  constexpr std::size_t kEstimatedSteps = 100;  // rough maps draw 50 frames together
  const auto& [truth, estimate] = std::tie(aligned.truth, aligned.estimate);
  if (const auto stretch = standingStretch(aligned, truth, estimate, kTrueSteps)) {
    const double way = distanceBetween(estimate, stretch->first, stretch->last);
    return standingText(aligned, *stretch, "truth", "estimate", way) +
           "are poses held or missing? All errors are wrong if so";
  }
  if (const auto stretch = standingStretch(aligned, estimate, truth, kEstimatedSteps)) {
    const double way = distanceBetween(truth, stretch->first, stretch->last);
    return standingText(aligned, *stretch, "estimate", "truth", way) +
           "is odometry lost, or its sensor, without saying so?";
  }
  return "";
}

std::string turnJumpHint(const Matches& matches) {
  double squares = 0;
  for (std::size_t i = 1; i < matches.size(); ++i) {
    squares += std::pow(turnAngle(matches.truth, i), 2) / static_cast<double>(matches.size());
  }
  for (std::size_t i = 3; i + 2 < matches.size(); ++i) {
    const double turn = turnAngle(matches.truth, i);
    const double others = squares - turn * turn / static_cast<double>(matches.size());
    if (!isTurnJump(matches, i, std::sqrt(std::max(0.0, others)))) continue;
    return fmt::format(
        "the truth turns by {:.3g} degrees in one step, to frame {}, where the estimate turns by "
        "{:.3g}: are its parts of different drives, or its poses wrong? All errors are wrong if so",
        turn / kRadiansPerDegree, matches.truth[i].frame,
        turnAngle(matches.estimate, i) / kRadiansPerDegree);
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
