// SPDX-License-Identifier: BSD-3-Clause
// Hand-made trajectories for the tests of evaluation.
#pragma once

#include <cmath>

#include "evaluation/association.hpp"
#include "tolman/context.hpp"
#include "tolman/geometry.hpp"

namespace tolman::test {

/// `poses` poses 1 m apart along the optical axis, 0.1 s apart.
inline evaluation::Trajectory straightPath(std::int64_t poses, double spacing_m = 1) {
  evaluation::Trajectory path;
  for (std::int64_t i = 0; i < poses; ++i) {
    evaluation::TrajectoryPose pose{i, i * 100'000'000, Eigen::Isometry3d::Identity()};
    pose.T_world_camera.translation().z() = spacing_m * static_cast<double>(i);
    path.push_back(pose);
  }
  return path;
}

/// A path that wanders through all of space.
inline evaluation::Trajectory wanderingPath(std::int64_t poses, RandomStream& random) {
  evaluation::Trajectory path = straightPath(poses);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (evaluation::TrajectoryPose& pose : path) {
    Vector6d twist;
    for (int i = 0; i < 3; ++i) twist[i] = random.normal();
    for (int i = 3; i < 6; ++i) twist[i] = 0.3 * random.normal();
    T = normalised(T * expSe3(twist));
    pose.T_world_camera = T;
  }
  return path;
}

inline Eigen::Isometry3d randomPose(RandomStream& random) {
  Vector6d twist;
  for (int i = 0; i < 3; ++i) twist[i] = random.uniform(-20, 20);
  twist.tail<3>() =
      Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized() *
      random.uniform(0, 3);
  return expSe3(twist);
}

/// The path seen from another world: T * pose, with lengths scaled first.
inline evaluation::Trajectory moved(evaluation::Trajectory path, const Eigen::Isometry3d& T,
                                    double scale = 1) {
  for (evaluation::TrajectoryPose& pose : path) {
    pose.T_world_camera.translation() *= scale;
    pose.T_world_camera = T * pose.T_world_camera;
  }
  return path;
}

inline evaluation::Matches paired(const evaluation::Trajectory& truth,
                                  const evaluation::Trajectory& estimate) {
  return evaluation::associateByFrame(truth, estimate).value();
}

}  // namespace tolman::test
