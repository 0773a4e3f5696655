// SPDX-License-Identifier: BSD-3-Clause
// The errors of path integration in the plane, while driving (path_calibration): what they did to
// each pose, and what accepted loops say of them.
#pragma once

#include <array>
#include <cmath>
#include <path_calibration.hpp>

namespace tolman::bayesian_attractor {

/// The planar errors, and the gain of distances.
inline constexpr int kPathErrors = kPlanarErrors + 1;
using ErrorVector = Eigen::Matrix<double, kPathErrors, 1>;
using ErrorMatrix = Eigen::Matrix<double, kPathErrors, kPathErrors>;
using ErrorEffect = Eigen::Matrix<double, 3, kPathErrors>;

/// Derivative of a pose (x, y, heading), in the axes of heading 0, by each error, and its shift by
/// the corrections that were applied on the way.
struct PathErrors {
  ErrorEffect effect = ErrorEffect::Zero();
  Eigen::Vector3d applied = Eigen::Vector3d::Zero();
};
PathErrors operator+(const PathErrors& a, const PathErrors& b);
PathErrors operator-(const PathErrors& a, const PathErrors& b);
/// The same after a rotation by `angle`.
PathErrors turned(const PathErrors& errors, double angle);
/// The errors of a pose that is fixed to one with these, displaced from it (m, axes of heading 0).
PathErrors displaced(const PathErrors& errors, const Eigen::Vector2d& displacement);

/// Effect of a short step over `seconds`, in the robot's axes.
ErrorEffect effectOf(const PlanarPose& step, double seconds);

/// The errors and their uncertainty, of a robot that is calibrated well, or badly.
struct ErrorEstimate {
  ErrorVector mean = ErrorVector::Zero();
  ErrorMatrix covariance = ErrorMatrix::Zero();
  double log_weight = 0;  ///< logarithm of its probability
};

/// A mixture of two Kalman filters over accepted loops: a prior with heavy tails. Most odometries
/// are calibrated, and one view may be enough for their first loop; those that are not are found by
/// the wide prior. And the factor on the standard deviation of noise, by Bayes' rule over a grid;
/// bumps are read more coarsely than a good odometry drifts between loops, so that they say nothing
/// of factors below 1.
struct RunningCalibration {
  static constexpr int kFactors = 5;  ///< 1, 2, 4, 8, 16
  std::array<ErrorEstimate, 2> estimates = priors();
  ErrorEstimate mixed = estimates[0];  ///< mean and covariance of the mixture
  Eigen::Matrix<double, kFactors, 1> log_factors = factorPrior();
  double noise = 1;  ///< the most probable factor

  static double factorAt(int k) { return std::ldexp(1.0, k); }
  static std::array<ErrorEstimate, 2> priors();
  static Eigen::Matrix<double, kFactors, 1> factorPrior();
  /// Recomputes `mixed` and `noise`.
  void mix();
  RunningCalibration() { mix(); }
};

/// A Kalman step by the `difference` that is `effect` times the error of the mean plus a noise with
/// this covariance. The gain of distances is considered, not estimated (Schmidt).
void update(ErrorEstimate& estimate, const ErrorEffect& effect, const Eigen::Vector3d& difference,
            const Eigen::Matrix3d& covariance);

}  // namespace tolman::bayesian_attractor
