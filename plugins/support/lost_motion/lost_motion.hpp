// SPDX-License-Identifier: BSD-3-Clause
// The motion that an odometry predicts while tracking is lost.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

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

// The velocity that is assumed while tracking is lost. The last frame before a loss is often
// disturbed already (blurred, partly covered), so its velocity alone is not trusted.

/// The last three measured velocities (m/s, rad/s), in order of time.
class RecentVelocities {
 public:
  void clear() { count_ = 0; }
  void add(const Vector6d& velocity) { velocities_[count_++ % velocities_.size()] = velocity; }
  /// The median of each component; of one or two velocities the last one, of none zero.
  Vector6d median() const {
    if (count_ == 0) return Vector6d::Zero();
    if (count_ < velocities_.size()) return velocities_[count_ - 1];
    Vector6d median;
    for (Eigen::Index i = 0; i < median.size(); ++i) {
      const auto [a, b, c] = std::array{velocities_[0][i], velocities_[1][i], velocities_[2][i]};
      median[i] = std::max(std::min(a, b), std::min(std::max(a, b), c));
    }
    return median;
  }

 private:
  std::array<Vector6d, 3> velocities_;
  std::size_t count_ = 0;  ///< of all that were added
};

}  // namespace tolman
