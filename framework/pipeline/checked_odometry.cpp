// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/checked_odometry.hpp"

#include <utility>

#include "host/prediction.hpp"

namespace tolman::pipeline {

Motion predictedMotion(const Frame& frame, const Motion& last) {
  Motion motion;
  motion.frame = frame.frame;
  motion.stamp_ns = frame.stamp_ns;
  if (last.frame < 0) return motion;  // nothing leads to the first frame
  motion.scale_known = last.scale_known;
  host::predict(motion, last, static_cast<double>(frame.stamp_ns - last.stamp_ns) * 1e-9);
  return motion;
}

std::optional<std::string> CheckedOdometry::admit(Frame& frame) {
  return check_images_ ? frame_check_.check(frame) : std::nullopt;
}

/// An odometry that follows something else than the world may be sure of itself.
Status CheckedOdometry::track(const Frame& frame, Motion& motion, std::string& impossible) {
  const Status status = odometry_.track(frame, motion);
  if (!status.isOk()) return status;
  impossible = motion_check_.check(motion).value_or("");
  if (!impossible.empty()) {
    replaced_.insert(frame.frame);
    Motion predicted = predictedMotion(frame, last_);
    predicted.revisions = std::move(motion.revisions);
    motion = std::move(predicted);
  }
  removeReplaced(motion.revisions);
  last_ = motion;
  last_.revisions.clear();
  last_.points.resize(Eigen::NoChange, 0);
  return status;
}

Status CheckedOdometry::finish(std::vector<MotionRevision>& revisions) {
  const Status status = odometry_.finish(revisions);
  removeReplaced(revisions);
  return status;
}

/// They improve a motion that was not believed.
void CheckedOdometry::removeReplaced(std::vector<MotionRevision>& revisions) const {
  if (replaced_.empty()) return;
  std::erase_if(revisions, [&](const MotionRevision& r) { return replaced_.contains(r.frame); });
}

}  // namespace tolman::pipeline
