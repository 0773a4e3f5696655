// SPDX-License-Identifier: BSD-3-Clause
#include "planar_link.hpp"

#include <Eigen/LU>
#include <cmath>

namespace tolman::experience_map {

Eigen::Vector3d residualOf(const PlanarLink& link, const PlanarPose& from, const PlanarPose& to) {
  const PlanarPose seen = between(from, to);
  return {seen.x - link.pose.x, seen.y - link.pose.y, wrapAngle(seen.theta - link.pose.theta)};
}

LinkDerivatives derivativesOf(const PlanarPose& from, const PlanarPose& to) {
  const PlanarPose seen = between(from, to);
  const double c = std::cos(from.theta);
  const double s = std::sin(from.theta);
  LinkDerivatives by;
  by.by_to << c, s, 0, -s, c, 0, 0, 0, 1;
  by.by_from = -by.by_to;
  by.by_from.block<2, 1>(0, 2) << seen.y, -seen.x;
  return by;
}

Eigen::Matrix3d informationOf(const Eigen::Matrix3d& covariance) {
  constexpr double kLeastVariance = 1e-12;
  return (covariance + kLeastVariance * Eigen::Matrix3d::Identity()).inverse();
}

}  // namespace tolman::experience_map
