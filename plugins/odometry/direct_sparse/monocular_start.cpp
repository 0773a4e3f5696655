// SPDX-License-Identifier: BSD-3-Clause
// Inverse depths of ground and walls.
#include "monocular_start.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::direct_sparse {

void draftDepths(const CameraRig& rig, double height, Keyframe& keyframe) {
  constexpr double kWall = 5;  // distance of the walls, in heights of the camera; chosen, not tuned
  constexpr double kFarthest = 40;    // largest depth, in heights of the camera; chosen, not tuned
  constexpr float kDeviation = 0.5F;  // of the inverse depth; chosen, not tuned
  for (ImmaturePoint& point : keyframe.immature) {
    const Eigen::Vector3d ray = rig.pinhole.ray({point.u, point.v});
    const double ground = ray.y();
    const double wall = std::fabs(ray.x()) / kWall;
    point.inverse_depth = static_cast<float>(std::max({ground, wall, 1 / kFarthest}) / height);
    point.sigma = kDeviation * point.inverse_depth;
    point.has_depth = true;
  }
}

void draftPoints(Keyframe& keyframe) {
  constexpr int kMaxFailures = 3;  // as in activation.cpp
  keyframe.points.clear();
  for (const ImmaturePoint& candidate : keyframe.immature) {
    if (candidate.failures >= kMaxFailures) continue;
    Point point;
    point.u = candidate.u;
    point.v = candidate.v;
    point.inverse_depth = candidate.inverse_depth;
    point.pattern = candidate.pattern;
    keyframe.points.push_back(point);
  }
}

}  // namespace tolman::direct_sparse
