// SPDX-License-Identifier: BSD-3-Clause
// Remembers the frames that odometry was given, and checks the `dt` of its motions against their
// stamps.
#pragma once

#include <cstdint>
#include <vector>

#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::host {

class MotionTimes {
 public:
  /// `motion` is the answer to `frame`. Its `dt` must be within a factor of ten of the time since
  /// the previous frame, because some plugins use a nominal rate. The previous frame is the last
  /// one that odometry was given or, if it failed there, the last one that it answered.
  Status check(const Frame& frame, const Motion& motion) const;
  /// To be called after each call, `answered` or not.
  void add(const Frame& frame, bool answered);
  /// The last frame; INT64_MAX if there was none.
  std::int64_t lastFrame() const { return last_frame_; }
  /// False for a frame between the first and the last that realtime dropped.
  bool wasGiven(std::int64_t frame) const;

 private:
  /// Numbers of frames that were left out, both ends included.
  struct Gap {
    std::int64_t first;
    std::int64_t last;
  };
  std::vector<Gap> gaps_;  // ascending
  std::int64_t last_frame_ = INT64_MAX;
  std::int64_t given_ns_ = 0;
  std::int64_t answered_ns_ = 0;
};

// The predicted motion for a frame without an answer of odometry: the last motion, in state Lost
// and with large covariance.

/// Keeps frame and stamp of `motion`. `dt` is the time since the previous frame, s.
inline void predict(Motion& motion, const Motion& last, double dt) {
  motion.state = TrackingState::Lost;
  motion.T_previous_current = last.T_previous_current;
  motion.covariance = Matrix6d::Identity();
  setPlanarVelocity(motion, dt);
}

}  // namespace tolman::host
