// SPDX-License-Identifier: BSD-3-Clause
#include "dead_reckoning.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::experience_map {
namespace {

/// Whether the motion has no height, pitch and roll, up to rounding.
bool isInPlane(const Eigen::Isometry3d& motion) {
  constexpr double kRounding = 1e-9;  // m and elements of the rotation
  return std::abs(motion.translation().y()) <= kRounding &&
         (motion.linear().col(1) - Eigen::Vector3d::UnitY()).cwiseAbs().maxCoeff() <= kRounding;
}

}  // namespace

Status DeadReckoning::check(const Motion& motion) const {
  if (frames_.empty() || motion.frame > frames_.back().frame) return Status::ok();
  return Status::invalidInput("motion of frame " + std::to_string(motion.frame) +
                              " comes after that of frame " + std::to_string(frames_.back().frame) +
                              "; frames must come in order");
}

void DeadReckoning::append(const Motion& motion, std::int64_t anchor) {
  ReckonedFrame reckoned;
  reckoned.frame = motion.frame;
  reckoned.stamp_ns = motion.stamp_ns;
  reckoned.anchor = anchor;
  reckoned.initialising = motion.state == TrackingState::Initialising;
  UncertainPose moved;
  if (!frames_.empty()) {
    reckoned.gap = reckoned.initialising && !frames_.back().initialising;
    moved = {motion.T_previous_current, motion.covariance};
    planar_ = planar_ && isInPlane(moved.T);
    metric_ = metric_ && motion.scale_known;
    if (motion.state != TrackingState::Tracking) {
      constexpr double kLostRotation = 0.1;  // rad; chosen, not tuned
      moved.covariance += isotropic(parameters_.assumed_sigma_translation / 3, kLostRotation);
    }
    reckoned.T_start_camera = normalised(frames_.back().T_start_camera * moved.T);
  }
  frames_.push_back(reckoned);
  motions_.push_back(moved);
}

std::size_t DeadReckoning::revise(std::span<const MotionRevision> revisions, std::size_t& unknown) {
  std::size_t first = frames_.size();
  unknown = 0;
  for (const MotionRevision& revision : revisions) {
    const std::optional<std::size_t> slot = slotOf(revision.frame);
    if (!slot) ++unknown;
    // The first frame and the frame after a gap have no motion.
    if (!slot || *slot == 0 || frames_[*slot].gap) continue;
    planar_ = planar_ && isInPlane(revision.T_previous_current);
    motions_[*slot] = {revision.T_previous_current, revision.covariance};
    first = std::min(first, *slot);
  }
  reckon(first);
  return first;
}

void DeadReckoning::reckon(std::size_t first) {
  for (std::size_t slot = first; slot < frames_.size(); ++slot) {
    frames_[slot].T_start_camera = normalised(frames_[slot - 1].T_start_camera * motions_[slot].T);
  }
}

void DeadReckoning::restore(ReckonedFrame frame, const UncertainPose& motion) {
  frame.T_start_camera = frames_.empty() ? Eigen::Isometry3d::Identity()
                                         : normalised(frames_.back().T_start_camera * motion.T);
  planar_ = planar_ && isInPlane(motion.T);
  frames_.push_back(frame);
  motions_.push_back(motion);
}

std::optional<std::size_t> DeadReckoning::slotOf(std::int64_t frame) const {
  const auto found = std::ranges::lower_bound(frames_, frame, {}, &ReckonedFrame::frame);
  if (found == frames_.end() || found->frame != frame) return std::nullopt;
  return static_cast<std::size_t>(found - frames_.begin());
}

PathMotion DeadReckoning::between(std::size_t from, std::size_t to) const {
  PathMotion sum;
  for (std::size_t slot = from + 1; slot <= to; ++slot) {
    const UncertainPose& motion = motions_[slot];
    sum.effect = adjointSe3(motion.T.inverse()) * sum.effect +
                 steadyEffect(motion.T, frames_[slot].gap ? 0 : seconds(slot - 1, slot));
    static_cast<UncertainPose&>(sum) = compose(sum, motion);
    sum.length += motion.T.translation().norm();
  }
  sum.T = frames_[from].T_start_camera.inverse() * frames_[to].T_start_camera;
  // Systematic drift, which covariances between frames do not contain. The minimal length keeps the
  // covariance of a link at standstill regular.
  constexpr double kMinLength = 0.01;  // m
  const double drifting = std::max(sum.length, kMinLength);
  sum.covariance +=
      isotropic(parameters_.drift_translation * drifting, parameters_.drift_rotation * drifting);
  return sum;
}

double DeadReckoning::seconds(std::size_t from, std::size_t to) const {
  return 1e-9 * static_cast<double>(frames_[to].stamp_ns - frames_[from].stamp_ns);
}

}  // namespace tolman::experience_map
