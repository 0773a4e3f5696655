// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/trajectory.hpp"

#include <algorithm>

namespace tolman::evaluation {

bool hasStamps(const Trajectory& trajectory) {
  return std::ranges::any_of(trajectory, [](const TrajectoryPose& p) { return p.stamp_ns != 0; });
}

Eigen::Matrix3Xd positions(const Trajectory& trajectory) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(trajectory.size()));
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    points.col(static_cast<Eigen::Index>(i)) = trajectory[i].T_world_camera.translation();
  }
  return points;
}

Eigen::Matrix3Xd centredPositions(const Trajectory& trajectory) {
  const Eigen::Matrix3Xd points = positions(trajectory);
  const Eigen::Vector3d mean = points.rowwise().mean();
  return points.colwise() - mean;
}

Eigen::Vector3d extentFromFirst(const Trajectory& trajectory) {
  if (trajectory.empty()) return Eigen::Vector3d::Zero();
  const Eigen::Matrix3Xd points =
      trajectory.front().T_world_camera.inverse() * positions(trajectory);
  return points.rowwise().maxCoeff() - points.rowwise().minCoeff();
}

std::vector<double> distances(const Trajectory& trajectory) {
  std::vector<double> result;
  result.reserve(trajectory.size());
  double distance = 0;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (i > 0 && trajectory[i].session == trajectory[i - 1].session) {
      distance += (trajectory[i].T_world_camera.translation() -
                   trajectory[i - 1].T_world_camera.translation())
                      .norm();
    }
    result.push_back(distance);
  }
  return result;
}

std::vector<double> stepLengths(const Trajectory& trajectory) {
  std::vector<double> result;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    result.push_back((trajectory[i].T_world_camera.translation() -
                      trajectory[i - 1].T_world_camera.translation())
                         .norm());
  }
  return result;
}

double pathLength(const Trajectory& trajectory) {
  return trajectory.empty() ? 0 : distances(trajectory).back();
}

}  // namespace tolman::evaluation
