// SPDX-License-Identifier: BSD-3-Clause
// Turns of matched trajectories that are long enough to be compared.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

inline constexpr double kDegree = std::numbers::pi / 180;  ///< rad

/// Whether the motion from pair i - 1 to pair i was tracked, within one piece of the path.
inline bool isTrackedStep(const Matches& matches, std::size_t i) {
  return matches.estimate[i].tracked && matches.estimate[i - 1].tracked &&
         matches.inOnePiece(i - 1, i);
}

/// Angle times axis, rad, in the axes of the camera at `from`.
inline Eigen::Vector3d turnBetween(const TrajectoryPose& from, const TrajectoryPose& to) {
  const Eigen::AngleAxisd rotation(
      (from.T_world_camera.inverse() * to.T_world_camera).linear().eval());
  return rotation.angle() * rotation.axis();
}

/// Calls visit(truth, estimate) for each turn. It ends where one of the two has turned by 5
/// degrees: over shorter ones the noise of both, such as the vibration of a car, is larger than the
/// turn. Turns in a gap of tracking or of the truth are left out, and those beyond a right angle:
/// about which axis is then uncertain.
template <class Visit>
void visitTurns(const Matches& matches, Visit&& visit) {
  constexpr double kTurn = 5 * kDegree;
  constexpr double kRight = 90 * kDegree;
  for (std::size_t begin = 0, i = 1; i < matches.size(); ++i) {
    if (!isTrackedStep(matches, i)) {
      begin = i;
      continue;
    }
    const Eigen::Vector3d truth = turnBetween(matches.truth[begin], matches.truth[i]);
    const Eigen::Vector3d estimate = turnBetween(matches.estimate[begin], matches.estimate[i]);
    const double larger = std::max(truth.norm(), estimate.norm());
    if (larger < kTurn) continue;
    begin = i;
    if (larger < kRight) visit(truth, estimate);
  }
}

}  // namespace tolman::evaluation
