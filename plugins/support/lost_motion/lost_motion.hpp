// SPDX-License-Identifier: BSD-3-Clause
// The motion that an odometry predicts while tracking is lost.
#pragma once

#include <algorithm>

#include "tolman/geometry.hpp"
#include "tolman/records.hpp"

namespace tolman {

struct LostMotion {
  Eigen::Isometry3d T_previous_current;
  Matrix6d covariance;
};

/// The last velocity (m/s, rad/s) is assumed for 5 s after tracking was lost; then the camera is
/// taken to stand, with the covariance of having gone straight on. 5 s: chosen, not tuned; usual
/// gaps are shorter. `lost_s`: time since the loss, at the frame before; `lost_frames`: frames
/// since then, this one included.
inline LostMotion lostMotion(const Vector6d& velocity, double lost_s, double dt, int lost_frames) {
  constexpr double kBelieved_s = 5;
  const double moving_s = std::clamp(kBelieved_s - lost_s, 0.0, dt);
  const Eigen::Isometry3d step = expSe3(velocity * moving_s);
  const Eigen::Isometry3d straight(Eigen::Translation3d(velocity.head<3>() * dt));
  return {step, predictionCovariance(moving_s < dt ? straight : step, lost_frames)};
}

}  // namespace tolman
