// SPDX-License-Identifier: BSD-3-Clause
#include "engine/checked_odometry.hpp"

#include <algorithm>
#include <utility>

#include "host/prediction.hpp"

namespace tolman::pipeline {

Motion predictedMotion(const Frame& frame, const Motion& last) {
  Motion motion;
  motion.frame = frame.frame;
  motion.stamp_ns = frame.stamp_ns;
  if (last.frame < 0) return motion;  // there is no motion before the first frame
  motion.scale_known = last.scale_known;
  host::predict(motion, last, static_cast<double>(frame.stamp_ns - last.stamp_ns) * 1e-9);
  return motion;
}

std::optional<std::string> CheckedOdometry::admit(Frame& frame) {
  return check_images_ ? frame_check_.check(frame) : std::nullopt;
}

Status CheckedOdometry::track(const Frame& frame, Motion& motion, Impossible& impossible) {
  const Status status = odometry_.track(frame, motion);
  if (!status.isOk()) {
    remember(predictedMotion(frame, last_));
    predicted_.add(last_);
    return status;
  }
  answered_.push_back({motion.frame, motion.dt, motion.scale_known});
  impossible.motion = motion_check_.check(motion).value_or("");
  if (!impossible.motion.empty()) {
    replaced_.insert(frame.frame);
    Motion predicted = predictedMotion(frame, last_);
    predicted.revisions = std::move(motion.revisions);
    motion = std::move(predicted);
  }
  filter(motion.revisions, impossible.revision);
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

Status CheckedOdometry::finish(std::vector<MotionRevision>& revisions, Impossible& impossible) {
  const Status status = odometry_.finish(revisions);
  filter(revisions, impossible.revision);
  for (MotionRevision& revision : revisions) predicted_.subtractFrom(revision);
  return status;
}

/// Removes impossible revisions; revisions of a replaced motion are removed without a reason.
void CheckedOdometry::filter(std::vector<MotionRevision>& revisions,
                             std::string& impossible) const {
  std::erase_if(revisions, [&](const MotionRevision& revision) {
    if (replaced_.contains(revision.frame)) return true;
    const std::optional<std::string> reason = reasonAgainst(revision);
    if (reason && impossible.empty()) {
      impossible = "of frame " + std::to_string(revision.frame) + " " + *reason;
    }
    return reason.has_value();
  });
}

std::optional<std::string> CheckedOdometry::reasonAgainst(const MotionRevision& revision) const {
  const auto found = std::ranges::lower_bound(answered_, revision.frame, {}, &Answered::frame);
  if (found == answered_.end() || found->frame != revision.frame) return std::nullopt;
  return motion_check_.checkRevision(revision, found->dt, found->scale_known);
}

}  // namespace tolman::pipeline
