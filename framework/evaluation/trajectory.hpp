// SPDX-License-Identifier: BSD-3-Clause
// A trajectory: camera poses in the order of time.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tolman::evaluation {

/// One pose. Frames grow strictly within a trajectory, and stamps too where they are known.
struct TrajectoryPose {
  std::int64_t frame = 0;
  std::int64_t stamp_ns = 0;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  bool tracked = true;      ///< false: odometry was lost or initialising
  std::size_t session = 0;  ///< how the robot came from one session to the next is not known
};
using Trajectory = std::vector<TrajectoryPose>;

/// Whether times are known: KITTI files have none, and all their stamps are 0.
bool hasStamps(const Trajectory& trajectory);

/// One column per pose, m.
Eigen::Matrix3Xd positions(const Trajectory& trajectory);
/// The same, relative to their mean.
Eigen::Matrix3Xd centredPositions(const Trajectory& trajectory);
/// Size of the box around the positions, along the axes of the first pose, m.
Eigen::Vector3d extentFromFirst(const Trajectory& trajectory);

/// Distance travelled up to each pose, m: as long as the trajectory, starting with 0. Nothing is
/// added from one session to the next.
std::vector<double> distances(const Trajectory& trajectory);

/// Distances between consecutive poses, m, also of two sessions.
std::vector<double> stepLengths(const Trajectory& trajectory);

/// Length of the whole path, m; 0 for fewer than two poses.
double pathLength(const Trajectory& trajectory);

}  // namespace tolman::evaluation
