// SPDX-License-Identifier: BSD-3-Clause
#include "motion_replay.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::motion_replay {

Status MotionReplay::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  seed_ = context.seed;
  return reset();
}

Status MotionReplay::reset() {
  random_ = RandomStream(seed_);
  last_step_ = {};
  last_stamp_ns_ = 0;
  return Status::ok();
}

PlanarPose MotionReplay::disturbed(const PlanarPose& step) {
  const Parameters& p = parameters_;
  const double distance = std::hypot(step.x, step.y);
  const double stretch = 1 + p.bias_distance + p.noise_distance * random_.normal();
  const double turn =
      p.bias_heading * distance + p.noise_heading * std::sqrt(distance) * random_.normal();
  return {step.x * stretch, step.y * stretch, wrapAngle(step.theta + turn)};
}

Status MotionReplay::track(const Frame& frame, Motion& motion) {
  motion.frame = frame.frame;
  motion.stamp_ns = frame.stamp_ns;
  const auto recorded =
      std::find_if(frame.sensors.begin(), frame.sensors.end(),
                   [](const NamedArray& array) { return array.name == "motion.planar"; });
  if (recorded == frame.sensors.end() || recorded->values.size() != 3) {
    return Status::unsupported(
        "this source measures no motion.planar; use the source motion_log, or another odometry");
  }
  const std::vector<float>& v = recorded->values;
  const PlanarPose step =
      disturbed({static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])});
  const bool lost = random_.uniform() < parameters_.lost;
  const double dt = static_cast<double>(frame.stamp_ns - last_stamp_ns_) * 1e-9;
  last_stamp_ns_ = frame.stamp_ns;
  if (frame.frame == 0 || frame.frame == parameters_.carried_at) return Status::ok();
  motion.state = lost ? TrackingState::Lost : TrackingState::Tracking;
  if (!lost) last_step_ = step;
  motion.T_previous_current = fromPlanar(last_step_);
  const double distance = std::hypot(last_step_.x, last_step_.y);
  const double factor = lost ? 10 : 1;  // of the standard deviations
  const double along = factor * (parameters_.sigma_distance * distance + 1e-3);
  const double turn = factor * (parameters_.sigma_heading * std::sqrt(distance) + 1e-4);
  motion.covariance.diagonal() << along * along, along * along, along * along, turn * turn,
      turn * turn, turn * turn;
  motion.tracked = lost ? 0 : 1;
  setPlanarVelocity(motion, dt);
  return Status::ok();
}

Status MotionReplay::finish(std::vector<MotionRevision>&) { return Status::ok(); }

}  // namespace tolman::motion_replay
