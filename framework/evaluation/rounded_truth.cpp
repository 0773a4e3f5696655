// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/rounded_truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "evaluation/errors.hpp"

namespace tolman::evaluation {
namespace {

constexpr double kFinest = 0.001;  // m; finer units do no harm
constexpr double kExact = 0.02;    // units; degrees of latitude are not exactly alike in metres

double restOf(double length, double unit) {
  return std::fabs(length - unit * std::round(length / unit));
}

/// Lengths of the steps along an axis, m, without zeros.
std::vector<double> stepsAlong(const Trajectory& truth, int axis) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const double step = std::fabs(truth[i].T_world_camera.translation()[axis] -
                                  truth[i - 1].T_world_camera.translation()[axis]);
    if (step > kExact * kFinest) steps.push_back(step);  // less is left of a conversion
  }
  return steps;
}

/// The greatest common divisor of the steps, m; 0 if there is none above kFinest.
double unitOf(const std::vector<double>& steps) {
  double unit = steps.empty() ? 0 : steps.front();
  for (double length : steps) {
    while (restOf(length, unit) > kExact * unit) {
      length = std::exchange(unit, restOf(length, unit));
      if (unit < kFinest) return 0;
    }
  }
  const bool divides_all =
      std::ranges::all_of(steps, [&](double step) { return restOf(step, unit) <= kExact * unit; });
  return divides_all ? unit : 0;
}

/// Whether the robot moves at changing speeds, by more than a unit, and unevenly. The steps of an
/// exact path that was made by hand are alike, or grow evenly.
bool stepsDiffer(const Trajectory& truth, double unit) {
  constexpr double kShare = 0.02;  // of the steps; chosen, not tuned
  constexpr double kUneven = 0.1;  // likewise; an even path has a few, where it changes
  const std::vector<double> steps = stepLengths(truth);
  const double usual = statistics(steps).median;
  const auto differ = [&](double difference) { return std::fabs(difference) > 0.3 * unit; };
  std::size_t others = 0;
  std::size_t uneven = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    others += differ(steps[i] - usual) ? 1 : 0;
    uneven += i >= 2 && differ(steps[i] - 2 * steps[i - 1] + steps[i - 2]) ? 1 : 0;
  }
  const auto count = static_cast<double>(steps.size());
  return static_cast<double>(others) > kShare * count &&
         static_cast<double>(uneven) > kUneven * count;
}

}  // namespace

Rounding roundingOf(const Trajectory& truth) {
  constexpr std::size_t kFewest = 10;  // poses
  Rounding rounding;
  if (truth.size() < kFewest) return rounding;
  double squares = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double unit = unitOf(stepsAlong(truth, axis));
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
      "the true positions are multiples of {:.3g} m, which alone makes an error of {:.2g} m, and "
      "the "
      "estimate has one of {:.2g} m: were they written with too few digits?",
      rounding.unit, rounding.error, rmse);
}

}  // namespace tolman::evaluation
