// SPDX-License-Identifier: BSD-3-Clause
#include "planar_link.hpp"

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

}  // namespace tolman::experience_map
