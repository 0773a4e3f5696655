// SPDX-License-Identifier: BSD-3-Clause
#include "path_errors.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace tolman::bayesian_attractor {

PathErrors operator+(const PathErrors& a, const PathErrors& b) {
  return {a.effect + b.effect, a.applied + b.applied};
}

PathErrors operator-(const PathErrors& a, const PathErrors& b) {
  return {a.effect - b.effect, a.applied - b.applied};
}

PathErrors turned(const PathErrors& errors, double angle) {
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(angle).toRotationMatrix();
  PathErrors there = errors;
  there.effect.topRows<2>() = R * errors.effect.topRows<2>();
  there.applied.head<2>() = R * errors.applied.head<2>();
  return there;
}

PathErrors displaced(const PathErrors& errors, const Eigen::Vector2d& displacement) {
  PathErrors there = errors;
  const Eigen::Vector2d across(-displacement.y(), displacement.x());
  there.effect.topRows<2>() += across * errors.effect.row(2);
  there.applied.head<2>() += across * errors.applied.z();
  return there;
}

ErrorEffect effectOf(const PlanarPose& step, double seconds) {
  ErrorEffect effect = ErrorEffect::Zero();
  effect.row(2) << step.theta, seconds, std::hypot(step.x, step.y), 0;
  effect(0, kPlanarErrors) = step.x;
  effect(1, kPlanarErrors) = step.y;
  return effect;
}

std::array<ErrorEstimate, 2> RunningCalibration::priors() {
  // Sigmas of a good calibration over those of a bad one, and how many are bad. Chosen so that one
  // view suffices for the loop of 07, which no other view supports, and no loop of 06 is false.
  constexpr double kCalibrated = 0.03;
  constexpr double kBad = 0.05;
  std::array<ErrorEstimate, 2> priors;
  ErrorVector sigmas;
  sigmas << kSteadyPrior[0], kSteadyPrior[1], kSteadyPrior[2], kDistancePrior;
  priors[0].covariance = sigmas.cwiseAbs2().asDiagonal();
  priors[1].covariance = kCalibrated * kCalibrated * priors[0].covariance;
  priors[0].log_weight = std::log(kBad);
  priors[1].log_weight = std::log(1 - kBad);
  return priors;
}

Eigen::Matrix<double, RunningCalibration::kFactors, 1> RunningCalibration::factorPrior() {
  constexpr double kSpread = 0.7;  // of the logarithm: a factor of two; chosen, not tuned
  Eigen::Matrix<double, kFactors, 1> prior;
  for (int k = 0; k < kFactors; ++k) {
    const double away = std::log(factorAt(k)) / kSpread;
    prior[k] = -0.5 * away * away;
  }
  return prior;
}

void RunningCalibration::mix() {
  const double most = std::max(estimates[0].log_weight, estimates[1].log_weight);
  double sum = 0;
  for (const ErrorEstimate& e : estimates) sum += std::exp(e.log_weight - most);
  mixed.mean.setZero();
  mixed.covariance.setZero();
  for (ErrorEstimate& e : estimates) {
    e.log_weight = std::max(e.log_weight - most - std::log(sum), -30.0);
    mixed.mean += std::exp(e.log_weight) * e.mean;
  }
  for (const ErrorEstimate& e : estimates) {
    const ErrorVector away = e.mean - mixed.mean;
    mixed.covariance += std::exp(e.log_weight) * (e.covariance + away * away.transpose());
  }
  log_factors.array() -= log_factors.maxCoeff();
  Eigen::Index most_probable = 0;
  log_factors.maxCoeff(&most_probable);
  noise = factorAt(static_cast<int>(most_probable));
}

void update(ErrorEstimate& estimate, const ErrorEffect& effect, const Eigen::Vector3d& difference,
            const Eigen::Matrix3d& covariance) {
  ErrorMatrix& P = estimate.covariance;
  const Eigen::Matrix3d S = covariance + effect * P * effect.transpose();
  Eigen::Matrix<double, kPathErrors, 3> gain = P * effect.transpose() * S.inverse();
  gain.row(kPlanarErrors).setZero();
  estimate.mean += gain * difference;
  const ErrorMatrix keep = ErrorMatrix::Identity() - gain * effect;
  P = keep * P * keep.transpose() + gain * covariance * gain.transpose();
}

}  // namespace tolman::bayesian_attractor
