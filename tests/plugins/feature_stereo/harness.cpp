// SPDX-License-Identifier: BSD-3-Clause
#include "harness.hpp"

#include <stdexcept>

namespace tolman::test {
Host::Host(const CameraRig& rig, ParameterValues values) : services_(std::move(values), 7) {
  services_.rig = rig;
  configured_ = plugin_.configure(services_);
}

Motion Host::track(const Frame& frame) {
  Motion motion;
  const Status status = plugin_.track(frame, motion);
  if (!status.isOk()) throw std::runtime_error(status.message());
  motions_.push_back(motion.T_previous_current);
  apply(motion.revisions);
  return motion;
}

void Host::finish() {
  std::vector<MotionRevision> revisions;
  const Status status = plugin_.finish(revisions);
  if (!status.isOk()) throw std::runtime_error(status.message());
  apply(revisions);
}

void Host::apply(const std::vector<MotionRevision>& revisions) {
  for (const MotionRevision& revision : revisions) {
    motions_.at(static_cast<std::size_t>(revision.frame)) = revision.T_previous_current;
  }
}

std::vector<Eigen::Isometry3d> Host::trajectory() const {
  std::vector<Eigen::Isometry3d> poses;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (const Eigen::Isometry3d& motion : motions_) poses.push_back(pose = pose * motion);
  return poses;
}

double Host::length() const {
  double metres = 0;
  for (const Eigen::Isometry3d& motion : motions_) metres += motion.translation().norm();
  return metres;
}

}  // namespace tolman::test
