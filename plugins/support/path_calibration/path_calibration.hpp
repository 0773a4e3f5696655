// SPDX-License-Identifier: BSD-3-Clause
// Steady errors of path integration. The brain recalibrates the gain of path integration when
// landmarks keep disagreeing with it (Jayakumar et al. 2019). Here the errors are unknowns b with a
// broad prior, next to the poses: a reported motion T is corrected to
//
//   T exp(E(T) b),    E: effect of each error on the end of the motion.
//
// A closed loop observes the sum of the effects along its path. What no loop observes stays at the
// prior, and its uncertainty is one error along the whole path: the variance of the pose grows with
// the square of distance or time, not in proportion to them as that of noise does.
#pragma once

#include <array>
#include <string>
#include <tolman/geometry.hpp>
#include <vector>

namespace tolman {

/// The errors that loops observe, in the order of their vector; the first three act in the plane.
/// Positive: missing in the reported motion.
namespace steady_error {
inline constexpr int kTurns = 0;  ///< rad/rad: the true turn is 1 + this times the reported one
inline constexpr int kTurnPerSecond = 1;  ///< rad/s to the left
inline constexpr int kTurnPerMetre = 2;   ///< rad/m to the left
inline constexpr int kLeft = 3;           ///< m/m, along the camera's axes
inline constexpr int kDown = 4;           ///< m/m, likewise
}  // namespace steady_error
inline constexpr int kPlanarErrors = 3;
inline constexpr int kSpatialErrors = 5;

/// Standard deviations before any loop: wide enough for wheels, a scanline camera and stereo.
inline constexpr std::array<double, kSpatialErrors> kSteadyPrior = {0.03, 0.005, 0.005, 0.003,
                                                                    0.003};
/// The gain of distances, m/m: no loop observes it, because the offsets that views measure are
/// short. It only widens the position.
inline constexpr double kDistancePrior = 0.03;

/// E of a motion over `seconds` in the tangent space of its end (translation, rotation).
Eigen::Matrix<double, 6, kSpatialErrors> steadyEffect(const Eigen::Isometry3d& motion,
                                                      double seconds);

/// What was learned about odometry.
struct PathCalibration {
  using Vector = Eigen::Matrix<double, kSpatialErrors, 1>;
  Vector errors = Vector::Zero();
  Vector sigmas = Eigen::Map<const Vector>(kSteadyPrior.data());
  double turning = 0;         ///< rad/s: turns per second and per metre at the mean speed
  double turning_sigma = 0;   ///< rad/s; 0: nothing was learned
  double noise_distance = 1;  ///< factor on the assumed standard deviation of translations
  double noise_turns = 1;     ///< the same of rotations
};

/// A sentence for each error that is known to be there, for the log.
std::vector<std::string> describe(const PathCalibration& calibration);

}  // namespace tolman
