// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/trajectory.hpp"

#include <algorithm>

namespace tolman::evaluation {

bool hasStamps(const Trajectory& trajectory) {
  return std::ranges::any_of(trajectory, [](const TrajectoryPose& p) { return p.stamp_ns != 0; });
}

bool hasOrientations(const Trajectory& trajectory) {
  return std::ranges::any_of(trajectory, [&](const TrajectoryPose& p) {
    return p.T_world_camera.linear() != trajectory.front().T_world_camera.linear();
  });
}

std::int64_t medianStep(const Trajectory& trajectory) {
  if (trajectory.size() < 2) return 0;
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    steps.push_back(trajectory[i].stamp_ns - trajectory[i - 1].stamp_ns);
  }
  const auto median = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
  std::nth_element(steps.begin(), median, steps.end());
  return *median;
}

std::optional<PoseAt> poseAt(const Trajectory& trajectory, std::int64_t stamp_ns,
                             std::int64_t longest_gap_ns) {
  const auto after = std::ranges::lower_bound(trajectory, stamp_ns, {}, &TrajectoryPose::stamp_ns);
  if (after == trajectory.end()) return std::nullopt;
  const auto index = static_cast<std::size_t>(after - trajectory.begin());
  if (after->stamp_ns == stamp_ns) return PoseAt{after->T_world_camera, index, 0};
  if (index == 0 || after->stamp_ns - (after - 1)->stamp_ns > longest_gap_ns) return std::nullopt;
  const Eigen::Isometry3d& a = (after - 1)->T_world_camera;
  const Eigen::Isometry3d& b = after->T_world_camera;
  const double share = static_cast<double>(stamp_ns - (after - 1)->stamp_ns) /
                       static_cast<double>(after->stamp_ns - (after - 1)->stamp_ns);
  PoseAt at{Eigen::Isometry3d::Identity(), index - 1, share};
  at.T_world_camera.linear() = Eigen::Quaterniond(a.linear())
                                   .slerp(share, Eigen::Quaterniond(b.linear()))
                                   .toRotationMatrix();
  at.T_world_camera.translation() = (1 - share) * a.translation() + share * b.translation();
  return at;
}

Trajectory movedBy(const Eigen::Isometry3d& T, Trajectory trajectory) {
  for (TrajectoryPose& pose : trajectory) pose.T_world_camera = T * pose.T_world_camera;
  return trajectory;
}

Trajectory ofBody(Trajectory trajectory, const Eigen::Isometry3d& T_camera_body) {
  for (TrajectoryPose& pose : trajectory) pose.T_world_camera = pose.T_world_camera * T_camera_body;
  return trajectory;
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
