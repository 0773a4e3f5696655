// SPDX-License-Identifier: BSD-3-Clause
#include "engine/checked_odometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tolman::engine {

std::optional<std::string> MotionCheck::check(const Motion& motion) {
  since_ += motion.dt;
  if (motion.state != TrackingState::Tracking || motion.dt <= 0) {
    if (motion.state == TrackingState::Initialising) speed_.reset();
    return std::nullopt;
  }
  if (auto reason = tooFast(motion.T_previous_current, motion.dt, motion.scale_known)) {
    return reason;
  }
  // Compares speeds, not velocities, which a clip that is played back and forth reverses at once.
  // At a high frame rate a small position error causes a large error of the acceleration.
  constexpr double kPositionError = 0.1;  // m
  const double speed = motion.T_previous_current.translation().norm() / motion.dt;
  const double change = motion.scale_known && speed_ ? std::fabs(speed - *speed_) : 0;
  if (change > settings_.max_acceleration * since_ + kPositionError / motion.dt) {
    return fmt::format(
        "changes its speed by {:.1f} m/s in {:.2g} s; checks.max_acceleration is {:.3g} m/s^2",
        change, since_, settings_.max_acceleration);
  }
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

void PredictedSpan::add(const Motion& prediction) {
  T_answered_given_ = normalised(T_answered_given_ * prediction.T_previous_current);
  predicted_ = true;
  given_ns_ = prediction.stamp_ns;
}

void PredictedSpan::subtractFrom(Motion& motion) {
  const double since_given = 1e-9 * static_cast<double>(motion.stamp_ns - given_ns_);
  const double since_answered = 1e-9 * static_cast<double>(motion.stamp_ns - answered_ns_);
  // A dt above the geometric mean of the two times is nearer to the time since the last answer.
  const bool spans = predicted_ && motion.state != TrackingState::Initialising &&
                     motion.dt * motion.dt > since_given * since_answered;
  if (spans) {
    motion.T_previous_current = normalised(T_answered_given_.inverse() * motion.T_previous_current);
    setPlanarVelocity(motion, since_given);
    subtracted_.emplace(motion.frame, T_answered_given_);
  }
  T_answered_given_.setIdentity();
  predicted_ = false;
  given_ns_ = answered_ns_ = motion.stamp_ns;
}

void PredictedSpan::subtractFrom(MotionRevision& revision) const {
  const auto found = subtracted_.find(revision.frame);
  if (found == subtracted_.end()) return;
  revision.T_previous_current = normalised(found->second.inverse() * revision.T_previous_current);
}

Motion predictedMotion(const Frame& frame, const Motion& last) {
  Motion motion;
  motion.frame = frame.frame;
  motion.stamp_ns = frame.stamp_ns;
  if (last.frame < 0) return motion;  // there is no motion before the first frame
  motion.scale_known = last.scale_known;
  motion.state = TrackingState::Lost;
  motion.T_previous_current = last.T_previous_current;
  motion.covariance = Matrix6d::Identity();
  setPlanarVelocity(motion, static_cast<double>(frame.stamp_ns - last.stamp_ns) * 1e-9);
  return motion;
}

Status CheckedOdometry::track(const Frame& frame, Motion& motion,
                              std::vector<std::string>& impossible) {
  const Status status = odometry_.track(frame, motion);
  if (!status.isOk()) {
    remember(predictedMotion(frame, last_));
    predicted_.add(last_);
    return status;
  }
  answered_.push_back({motion.frame, motion.dt, motion.scale_known});
  if (const auto reason = motion_check_.check(motion)) {
    impossible.push_back("the motion " + *reason + "; it is predicted instead");
    replaced_.insert(frame.frame);
    Motion predicted = predictedMotion(frame, last_);
    predicted.revisions = std::move(motion.revisions);
    motion = std::move(predicted);
  }
  filter(motion.revisions, impossible);
  predicted_.subtractFrom(motion);
  for (MotionRevision& revision : motion.revisions) predicted_.subtractFrom(revision);
  remember(motion);
  return status;
}

void CheckedOdometry::remember(const Motion& motion) {
  last_ = motion;
  last_.revisions.clear();
  last_.points.resize(Eigen::NoChange, 0);
}

Status CheckedOdometry::finish(std::vector<MotionRevision>& revisions,
                               std::vector<std::string>& impossible) {
  const Status status = odometry_.finish(revisions);
  filter(revisions, impossible);
  for (MotionRevision& revision : revisions) predicted_.subtractFrom(revision);
  return status;
}

/// Removes impossible revisions; revisions of a replaced motion are removed without a reason.
void CheckedOdometry::filter(std::vector<MotionRevision>& revisions,
                             std::vector<std::string>& impossible) const {
  bool is_first = true;
  std::erase_if(revisions, [&](const MotionRevision& revision) {
    if (replaced_.contains(revision.frame)) return true;
    const auto of = std::ranges::lower_bound(answered_, revision.frame, {}, &Answered::frame);
    if (of == answered_.end() || of->frame != revision.frame) return false;
    const auto reason = motion_check_.checkRevision(revision, of->dt, of->scale_known);
    if (reason && std::exchange(is_first, false)) {
      impossible.push_back(
          fmt::format("the revision of frame {} {}; it is left out", revision.frame, *reason));
    }
    return reason.has_value();
  });
}

}  // namespace tolman::engine
