// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/rounded_truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "evaluation/errors.hpp"

namespace tolman::evaluation {
namespace {

// Decimal ones, and those of numbers of 32 bits, in m.
constexpr std::array<double, 17> kUnits = {1000,    100,      10,   8,         4,    2,
                                           1,       0.5,      0.25, 0.125,     0.1,  0.0625,
                                           0.03125, 0.015625, 0.01, 0.0078125, 0.001};

bool areMultiples(const Trajectory& truth, int axis, double unit) {
  constexpr double kExact = 1e-4;  // units; what is left of numbers of six and more digits
  const double first = truth.front().T_world_camera.translation()[axis];
  return std::ranges::all_of(truth, [&](const TrajectoryPose& pose) {
    const double units = (pose.T_world_camera.translation()[axis] - first) / unit;
    return std::fabs(units - std::round(units)) < kExact;
  });
}

bool moves(const Trajectory& truth, int axis) {
  const double first = truth.front().T_world_camera.translation()[axis];
  return std::ranges::any_of(truth, [&](const TrajectoryPose& pose) {
    return pose.T_world_camera.translation()[axis] != first;
  });
}

/// The coarsest unit of an axis, m; 0 if there is none.
double unitOf(const Trajectory& truth, int axis) {
  const auto unit = std::ranges::find_if(
      kUnits, [&](double candidate) { return areMultiples(truth, axis, candidate); });
  return unit == kUnits.end() ? 0 : *unit;
}

/// Whether the robot moves at changing speeds, by more than a unit. The steps of an exact path that
/// was made by hand are alike.
bool stepsDiffer(const Trajectory& truth, double unit) {
  constexpr double kShare = 0.02;  // of the steps; chosen, not tuned
  std::vector<double> steps;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    steps.push_back(
        (truth[i].T_world_camera.translation() - truth[i - 1].T_world_camera.translation()).norm());
  }
  const double usual = statistics(steps).median;
  const auto others = std::ranges::count_if(
      steps, [&](double step) { return std::fabs(step - usual) > 0.3 * unit; });
  return static_cast<double>(others) > kShare * static_cast<double>(steps.size());
}

}  // namespace

Rounding roundingOf(const Trajectory& truth) {
  constexpr std::size_t kFewest = 10;  // poses
  Rounding rounding;
  if (truth.size() < kFewest) return rounding;
  double squares = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!moves(truth, axis)) continue;
    const double unit = unitOf(truth, axis);
    squares += unit * unit / 12;
    rounding.unit = std::max(rounding.unit, unit);
  }
  if (stepsDiffer(truth, rounding.unit)) rounding.error = std::sqrt(squares);
  return rounding;
}

std::string roundedHint(const Rounding& rounding, double rmse) {
  constexpr double kShare = 1.0 / 3;  // of the error, a tenth of its square; chosen, not tuned
  constexpr double kPresent = 1.5;    // an error that is smaller contains no rounding; chosen
  if (rounding.error == 0 || rounding.error < kShare * rmse) return "";
  if (rounding.error > kPresent * rmse) return "";
  return fmt::format(
      "the true positions are multiples of {:g} m, which alone makes an error of {:.2g} m, and the "
      "estimate has one of {:.2g} m: were they written with too few digits?",
      rounding.unit, rounding.error, rmse);
}

}  // namespace tolman::evaluation
