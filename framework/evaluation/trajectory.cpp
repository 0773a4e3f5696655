// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/trajectory.hpp"

#include <algorithm>

namespace tolman::evaluation {

bool hasStamps(const Trajectory& trajectory) {
  return std::ranges::any_of(trajectory, [](const TrajectoryPose& p) { return p.stamp_ns != 0; });
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
