// SPDX-License-Identifier: BSD-3-Clause
// The stand-in for a motion that odometry could not give: it goes on as before, and nobody believes
// it.
#pragma once

#include "tolman/records.hpp"

namespace tolman::plugins {

/// Frame and stamp of `motion` stay; `dt` is the time since the frame before, s.
inline void predict(Motion& motion, const Motion& last, double dt) {
  motion.state = TrackingState::Lost;
  motion.T_previous_current = last.T_previous_current;
  motion.covariance = Matrix6d::Identity();
  setPlanarVelocity(motion, dt);
}

}  // namespace tolman::plugins
