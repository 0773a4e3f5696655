// SPDX-License-Identifier: BSD-3-Clause
// An odometry that uses only the SDK headers: 5 m/s straight ahead.
#include <tolman/plugin.hpp>

class HalfSpeed : public tolman::Odometry {
 public:
  using Parameters = tolman::NoParameters;

  tolman::Status configure(const tolman::Context&) override { return tolman::Status::ok(); }
  tolman::Status reset() override { return tolman::Status::ok(); }
  tolman::Status track(const tolman::Frame& frame, tolman::Motion& motion) override {
    motion.frame = frame.frame;
    motion.stamp_ns = frame.stamp_ns;
    if (frame.frame > 0) {
      motion.state = tolman::TrackingState::Tracking;
      motion.T_previous_current.translation().z() = 0.5;
      motion.covariance = 1e-4 * tolman::Matrix6d::Identity();
      tolman::setPlanarVelocity(motion, 0.1);
    }
    return tolman::Status::ok();
  }
  tolman::Status finish(std::vector<tolman::MotionRevision>&) override {
    return tolman::Status::ok();
  }
};

TOLMAN_PLUGIN(half_speed, HalfSpeed, "1.0.0", "Five metres a second, whatever it sees.");
