// SPDX-License-Identifier: BSD-3-Clause
#include "engine/motion_check.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tolman::pipeline {

std::optional<std::string> MotionCheck::check(const Motion& motion) {
  since_ += motion.dt;
  if (motion.state != TrackingState::Tracking || motion.dt <= 0) {
    if (motion.state == TrackingState::Initialising) speed_.reset();
    return std::nullopt;
  }
  const double speed = motion.T_previous_current.translation().norm() / motion.dt;
  if (auto reason = reasonAgainst(motion, speed)) return reason;
  speed_ = speed;
  since_ = 0;
  return std::nullopt;
}

std::optional<std::string> MotionCheck::checkRevision(const MotionRevision& revision, double dt,
                                                      bool scale_known) const {
  if (dt <= 0) return std::nullopt;
  return tooFast(revision.T_previous_current, dt, scale_known);
}

std::optional<std::string> MotionCheck::tooFast(const Eigen::Isometry3d& moved, double dt,
                                                bool scale_known) const {
  const double turn_rate = Eigen::AngleAxisd(moved.linear()).angle() / dt;
  if (turn_rate > settings_.max_turn_rate) {
    return fmt::format("turns by {:.1f} rad/s; checks.max_turn_rate is {:.3g}", turn_rate,
                       settings_.max_turn_rate);
  }
  const double speed = moved.translation().norm() / dt;
  if (!scale_known || speed <= settings_.max_speed) return std::nullopt;
  return fmt::format("has a speed of {:.0f} m/s; checks.max_speed is {:.3g}", speed,
                     settings_.max_speed);
}

std::optional<std::string> MotionCheck::reasonAgainst(const Motion& motion, double speed) const {
  if (auto reason = tooFast(motion.T_previous_current, motion.dt, motion.scale_known)) {
    return reason;
  }
  if (!motion.scale_known || !speed_) return std::nullopt;
  // Compares speeds, not velocities, which a clip that is played back and forth reverses at once.
  // At a high frame rate a small position error causes a large error of the acceleration.
  constexpr double kPositionError = 0.1;  // m
  const double change = std::fabs(speed - *speed_);
  if (change <= settings_.max_acceleration * since_ + kPositionError / motion.dt) {
    return std::nullopt;
  }
  return fmt::format(
      "changes its speed by {:.1f} m/s in {:.2g} s; checks.max_acceleration is "
      "{:.3g} m/s^2",
      change, since_, settings_.max_acceleration);
}

}  // namespace tolman::pipeline
