// SPDX-License-Identifier: BSD-3-Clause
// Matrices of the form of adjoints are stored as their 3x3 blocks; the one at the bottom left is
// zero.
#include "pose_link.hpp"

#include <array>
#include <cmath>

namespace tolman::experience_map {

Eigen::Vector3d residualOf(const PlanarLink& link, const PlanarPose& from, const PlanarPose& to) {
  const PlanarPose seen = between(from, to);
  return {seen.x - link.pose.x, seen.y - link.pose.y, wrapAngle(seen.theta - link.pose.theta)};
}

LinkDerivatives<Plane> derivativesOf(const PlanarLink& link, const PlanarPose& from,
                                     const PlanarPose& to) {
  const PlanarPose seen = between(from, to);
  const double c = std::cos(from.theta);
  const double s = std::sin(from.theta);
  LinkDerivatives<Plane> by;
  by.residual = residualOf(link, from, to);
  by.by_to << c, s, 0, -s, c, 0, 0, 0, 1;
  by.by_from = -by.by_to;
  by.by_from.block<2, 1>(0, 2) << seen.y, -seen.x;
  return by;
}

PlanarPose moved(const PlanarPose& pose, const Eigen::Vector3d& step) {
  return {pose.x + step.x(), pose.y + step.y(), wrapAngle(pose.theta + step.z())};
}

namespace {

/// [turn, shift; 0, turn], a matrix of the form of ad(r) and Ad(T).
struct Upper {
  Eigen::Matrix3d turn;
  Eigen::Matrix3d shift;

  Matrix6d dense() const {
    Matrix6d matrix;
    matrix.topLeftCorner<3, 3>() = turn;
    matrix.topRightCorner<3, 3>() = shift;
    matrix.bottomLeftCorner<3, 3>().setZero();
    matrix.bottomRightCorner<3, 3>() = turn;
    return matrix;
  }
};

Upper operator*(const Upper& a, const Upper& b) {
  Upper product;
  product.turn.noalias() = a.turn * b.turn;
  product.shift.noalias() = a.turn * b.shift;
  product.shift.noalias() += a.shift * b.turn;
  return product;
}

/// J(r) = sum over n of B_n / n! * (-ad r)^n with the Bernoulli numbers B_n (B_1 = -1/2). Converges
/// below a turn of 2 pi; after the tenth power the rest is below 1e-3 even at pi.
Upper inverseRightJacobian(const Vector6d& r) {
  constexpr std::array kEven = {1.0 / 12, -1.0 / 720, 1.0 / 30240, -1.0 / 1209600, 1.0 / 47900160};
  const Upper ad = {skew(r.tail<3>()), skew(r.head<3>())};
  const Upper squared = ad * ad;
  Upper sum = {Eigen::Matrix3d::Identity() + 0.5 * ad.turn, 0.5 * ad.shift};
  Upper power = squared;
  for (const double factor : kEven) {
    sum.turn += factor * power.turn;
    sum.shift += factor * power.shift;
    const double largest =
        std::max(power.turn.cwiseAbs().maxCoeff(), power.shift.cwiseAbs().maxCoeff());
    if (largest < 1e-12) break;  // the other terms are below rounding
    power = power * squared;
  }
  return sum;
}

/// V^-1 of the rotation vector w times a translation. Closed form, without solving a system:
/// V^-1 = 1 - W / 2 + (1 - |w| / 2 * cot(|w| / 2)) / |w|^2 * W^2.
Eigen::Vector3d turnedBack(const Eigen::Vector3d& w, const Eigen::Vector3d& translation) {
  const double square = w.squaredNorm();
  double factor = 1.0 / 12 + square / 720;
  if (square > 1e-6) {  // rad^2; below it the quotient loses digits, and the series is exact
    const double half = 0.5 * std::sqrt(square);
    factor = (1 - half * std::cos(half) / std::sin(half)) / square;
  }
  const Eigen::Vector3d across = w.cross(translation);
  return translation - 0.5 * across + factor * w.cross(across);
}

}  // namespace

Vector6d residualOf(const SpatialLink& link, const Eigen::Isometry3d& from,
                    const Eigen::Isometry3d& to) {
  const Eigen::Matrix3d R_from_to = from.linear().transpose() * to.linear();
  const Eigen::Vector3d shift =
      from.linear().transpose() * (to.translation() - from.translation()) - link.pose.translation();
  Vector6d residual;
  residual.tail<3>() = logSo3(link.pose.linear().transpose() * R_from_to);
  residual.head<3>() = turnedBack(residual.tail<3>(), link.pose.linear().transpose() * shift);
  return residual;
}

LinkDerivatives<Space> derivativesOf(const SpatialLink& link, const Eigen::Isometry3d& from,
                                     const Eigen::Isometry3d& to) {
  LinkDerivatives<Space> by;
  by.residual = residualOf(link, from, to);
  const Upper by_to = inverseRightJacobian(by.residual);
  const Eigen::Matrix3d R_to_from = to.linear().transpose() * from.linear();
  const Eigen::Vector3d back = to.linear().transpose() * (from.translation() - to.translation());
  const Upper by_from = by_to * Upper{-R_to_from, -skew(back) * R_to_from};
  by.by_to = by_to.dense();
  by.by_from = by_from.dense();
  return by;
}

Eigen::Isometry3d moved(const Eigen::Isometry3d& pose, const Vector6d& step) {
  return normalised(pose * expSe3(step));
}

}  // namespace tolman::experience_map
