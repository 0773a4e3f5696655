// SPDX-License-Identifier: BSD-3-Clause
// The predicted motion for a frame without an answer of odometry: the last motion, in state Lost
// and with large covariance.
#pragma once

#include "tolman/records.hpp"

namespace tolman::host {

/// Keeps frame and stamp of `motion`. `dt` is the time since the previous frame, s.
inline void predict(Motion& motion, const Motion& last, double dt) {
  motion.state = TrackingState::Lost;
  motion.T_previous_current = last.T_previous_current;
  motion.covariance = Matrix6d::Identity();
  setPlanarVelocity(motion, dt);
}

}  // namespace tolman::host
