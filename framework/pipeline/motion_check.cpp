// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/motion_check.hpp"

#include <fmt/format.h>

namespace tolman::pipeline {

std::optional<std::string> MotionCheck::check(const Motion& motion) {
  since_ += motion.dt;
  if (motion.state != TrackingState::Tracking || motion.dt <= 0) {
    if (motion.state == TrackingState::Initialising) has_velocity_ = false;
    return std::nullopt;
  }
  const Eigen::Vector3d velocity = motion.T_previous_current.translation() / motion.dt;
  if (auto reason = reasonAgainst(motion, velocity)) return reason;
  has_velocity_ = true;
  velocity_ = velocity;
  since_ = 0;
  return std::nullopt;
}

std::optional<std::string> MotionCheck::reasonAgainst(const Motion& motion,
                                                      const Eigen::Vector3d& velocity) {
  const double turn_rate =
      Eigen::AngleAxisd(motion.T_previous_current.linear()).angle() / motion.dt;
  if (turn_rate > settings_.max_turn_rate) {
    return fmt::format("turns by {:.1f} rad/s; checks.max_turn_rate is {:.3g}", turn_rate,
                       settings_.max_turn_rate);
  }
  if (!motion.scale_known) return std::nullopt;
  if (velocity.norm() > settings_.max_speed) {
    return fmt::format("has a speed of {:.0f} m/s; checks.max_speed is {:.3g}", velocity.norm(),
                       settings_.max_speed);
  }
  if (!has_velocity_) return std::nullopt;
  // A small error of a position is a large one of the acceleration where frames follow fast.
  constexpr double kPositionError = 0.1;  // m
  const double change = (velocity - velocity_).norm();
  if (change <= settings_.max_acceleration * since_ + kPositionError / motion.dt) {
    return std::nullopt;
  }
  return fmt::format(
      "changes its velocity by {:.1f} m/s in {:.2g} s; checks.max_acceleration is "
      "{:.3g} m/s^2",
      change, since_, settings_.max_acceleration);
}

}  // namespace tolman::pipeline
