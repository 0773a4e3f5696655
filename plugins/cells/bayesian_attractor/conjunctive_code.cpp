// SPDX-License-Identifier: BSD-3-Clause
#include "conjunctive_code.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace tolman::bayesian_attractor {
namespace {

Eigen::Vector2d turned(double x, double y, double angle) {
  return Eigen::Rotation2Dd(angle) * Eigen::Vector2d(x, y);
}

}  // namespace

FiringPattern ConjunctiveCode::displaced(const FiringPattern& pattern, const PlanarPose& step,
                                         double climb) const {
  FiringPattern there = pattern;
  height_.move(there.heights, climb);
  grid_.move(there.phases, turned(step.x, step.y, pattern.heading));
  there.heading = wrapPeriod(pattern.heading + step.theta, kTurn);
  return there;
}

Eigen::Vector3d ConjunctiveCode::difference(const FiringPattern& from,
                                            const FiringPattern& to) const {
  Eigen::Vector3d difference;
  difference << grid_.displacement(from.phases, to.phases), wrapAngle(to.heading - from.heading);
  return difference;
}

PlanarPose ConjunctiveCode::between(const FiringPattern& from, const FiringPattern& to) const {
  const Eigen::Vector3d displacement = difference(from, to);
  const Eigen::Vector2d own = turned(displacement.x(), displacement.y(), -from.heading);
  return {own.x(), own.y(), displacement.z()};
}

double ConjunctiveCode::climb(const FiringPattern& from, const FiringPattern& to) const {
  return height_.difference(from.heights, to.heights);
}

void ConjunctiveCode::move(Bump& bump, const PlanarPose& step, const Eigen::Matrix3d& noise,
                           const Climb& climb, const PathErrors& errors) const {
  const double heading = bump.centre.heading;
  const Eigen::Vector2d displacement = turned(step.x, step.y, heading);
  const Eigen::Matrix3d J = displacementJacobian(displacement);
  bump.errors = bayesian_attractor::displaced(bump.errors, displacement) +
                bayesian_attractor::turned(errors, heading);
  bump.covariance = J * bump.covariance * J.transpose() + turned(noise, heading);
  bump.centre = displaced(bump.centre, step, climb.metres);
  bump.height_variance += climb.variance;
}

void ConjunctiveCode::shift(FiringPattern& pattern, const Eigen::Vector3d& by) const {
  grid_.move(pattern.phases, by.head<2>());
  pattern.heading = wrapPeriod(pattern.heading + by.z(), kTurn);
}

void ConjunctiveCode::fuse(Bump& bump, const FiringPattern& seen, const Eigen::Matrix3d& covariance,
                           double height_variance) const {
  const Eigen::Matrix3d sum = bump.covariance + covariance;
  const Eigen::Matrix3d gain = bump.covariance * sum.inverse();
  shift(bump.centre, gain * difference(bump.centre, seen));
  bump.covariance = gain * covariance;
  const double height_sum = bump.height_variance + height_variance;
  if (height_sum <= 0) return;
  const double height_gain = bump.height_variance / height_sum;
  height_.move(bump.centre.heights, height_gain * climb(bump.centre, seen));
  bump.height_variance = height_gain * height_variance;
}

Eigen::Matrix3d ConjunctiveCode::readout() const {
  const double heading = grid_.phaseSigma() * kTurn;
  return Eigen::Vector3d(grid_.sigma(), grid_.sigma(), heading).cwiseAbs2().asDiagonal();
}

Eigen::Matrix3d turned(const Eigen::Matrix3d& covariance, double angle) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(angle).toRotationMatrix();
  return R * covariance * R.transpose();
}

Eigen::Matrix3d displacementJacobian(const Eigen::Vector2d& displacement) {
  Eigen::Matrix3d J = Eigen::Matrix3d::Identity();
  J(0, 2) = -displacement.y();
  J(1, 2) = displacement.x();
  return J;
}

Eigen::Matrix3d absolute(const Eigen::Matrix3d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spectrum(symmetric);
  const Eigen::Matrix3d& V = spectrum.eigenvectors();
  return V * spectrum.eigenvalues().cwiseAbs().asDiagonal() * V.transpose();
}

double squaredMahalanobis(const Eigen::Vector3d& difference, const Eigen::Matrix3d& covariance) {
  const Eigen::Vector3d chord(difference.x(), difference.y(), 2 * std::sin(0.5 * difference.z()));
  return chord.dot(covariance.inverse() * chord);
}

}  // namespace tolman::bayesian_attractor
