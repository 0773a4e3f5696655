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
  if (!parameters_.record.empty()) {
    if (parameters_.lost > 0 || parameters_.carried_at >= 0) {
      return Status::invalidParameter(
          "lost and carried_at need the motion of the source; leave them out with record");
    }
    if (Status opened = reader_.open(parameters_.record); !opened.isOk()) return opened;
  }
  return reset();
}

Status MotionReplay::reset() {
  random_ = RandomStream(seed_);
  last_step_ = {};
  last_stamp_ns_ = 0;
  disturbances_.clear();
  return Status::ok();
}

MotionReplay::Disturbance MotionReplay::draw(double distance) {
  const Parameters& p = parameters_;
  const double stretch = 1 + p.bias_distance + p.noise_distance * random_.normal();
  const double turn =
      p.bias_heading * distance + p.noise_heading * std::sqrt(distance) * random_.normal();
  return {stretch, turn, p.bias_height * distance * stretch};
}

/// The recorded motion; without noise and bias it is identical bit for bit.
Status MotionReplay::replay(const Frame& frame, Motion& motion) {
  Status status = reader_.read(frame, motion);
  if (!status.isOk()) return status;
  const Parameters& p = parameters_;
  if (p.noise_distance == 0 && p.noise_heading == 0 && p.bias_distance == 0 &&
      p.bias_heading == 0 && p.bias_height == 0) {
    return status;
  }
  disturbances_.resize(static_cast<std::size_t>(frame.frame) + 1);
  if (motion.state != TrackingState::Initialising) {
    disturbances_.back() = draw(motion.T_previous_current.translation().norm());
    disturb(frame.frame, motion.T_previous_current);
    setPlanarVelocity(motion, motion.dt);
  }
  for (MotionRevision& revision : motion.revisions) {
    disturb(revision.frame, revision.T_previous_current);
  }
  return status;
}

/// Applies the disturbance of a frame to its motion or to a revision of it.
void MotionReplay::disturb(std::int64_t frame, Eigen::Isometry3d& T_previous_current) const {
  if (frame < 0 || frame >= static_cast<std::int64_t>(disturbances_.size())) return;
  const Disturbance& wrong = disturbances_[static_cast<std::size_t>(frame)];
  T_previous_current.translation() *= wrong.stretch;
  T_previous_current.translation().y() += wrong.sink;
  T_previous_current.linear() *= fromPlanar({0, 0, wrong.turn}).linear();
}

const std::vector<float>* MotionReplay::sensor(const Frame& frame, std::string_view name) {
  const auto found = std::find_if(frame.sensors.begin(), frame.sensors.end(),
                                  [&](const NamedArray& array) { return array.name == name; });
  return found == frame.sensors.end() ? nullptr : &found->values;
}

/// Whether tracking restarts at an unknown pose at this frame, by the parameter or the source.
bool MotionReplay::carried(const Frame& frame) const {
  return frame.frame == parameters_.carried_at || isNotZero(frame, "motion.unknown");
}

/// Whether the frame has this sensor with a value that is not 0.
bool MotionReplay::isNotZero(const Frame& frame, std::string_view name) {
  const std::vector<float>* values = sensor(frame, name);
  return values && std::ranges::any_of(*values, [](float value) { return value != 0; });
}

Status MotionReplay::track(const Frame& frame, Motion& motion) {
  if (!parameters_.record.empty()) return replay(frame, motion);
  motion.frame = frame.frame;
  motion.stamp_ns = frame.stamp_ns;
  const std::vector<float>* recorded = sensor(frame, "motion.planar");
  if (!recorded || recorded->size() != 3) {
    return Status::unsupported(
        "this source measures no motion.planar; use one that does, such as motion_log or a ROS bag "
        "with an odometry topic, or another odometry");
  }
  const std::vector<float>& v = *recorded;
  const PlanarPose recorded_step = {static_cast<double>(v[0]), static_cast<double>(v[1]),
                                    static_cast<double>(v[2])};
  const Disturbance wrong = draw(std::hypot(recorded_step.x, recorded_step.y));
  const PlanarPose step = {recorded_step.x * wrong.stretch, recorded_step.y * wrong.stretch,
                           wrapAngle(recorded_step.theta + wrong.turn)};
  const bool drawn_lost = random_.uniform() < parameters_.lost;
  const bool guessed = isNotZero(frame, "motion.lost");  // by the source
  const bool lost = drawn_lost || guessed;
  const double dt = static_cast<double>(frame.stamp_ns - last_stamp_ns_) * 1e-9;
  last_stamp_ns_ = frame.stamp_ns;
  if (frame.frame == 0 || carried(frame)) return Status::ok();
  motion.state = lost ? TrackingState::Lost : TrackingState::Tracking;
  const PlanarPose moved = guessed || !lost ? step : last_step_;
  // The camera may have gone on where the source's guess is that it stands.
  const double before = guessed ? std::hypot(last_step_.x, last_step_.y) : 0;
  if (!lost) last_step_ = step;
  motion.T_previous_current = fromPlanar(moved);
  const double distance = std::max(before, std::hypot(moved.x, moved.y));
  motion.T_previous_current.translation().y() += parameters_.bias_height * distance;
  const double factor = lost ? 10 : 1;  // multiplies the standard deviations; chosen, not tuned
  // 1e-3 m and 1e-4 rad keep the covariance regular at standstill.
  const double along = factor * (parameters_.sigma_distance * distance + 1e-3);
  const double turn = factor * (parameters_.sigma_heading * std::sqrt(distance) + 1e-4);
  motion.covariance.diagonal() << along * along, along * along, along * along, turn * turn,
      turn * turn, turn * turn;
  motion.tracked = lost ? 0 : 1;
  setPlanarVelocity(motion, dt);
  return Status::ok();
}

Status MotionReplay::finish(std::vector<MotionRevision>& revisions) {
  if (parameters_.record.empty()) return Status::ok();
  Status status = reader_.read(revisions);
  for (MotionRevision& revision : revisions) disturb(revision.frame, revision.T_previous_current);
  return status;
}

}  // namespace tolman::motion_replay
