// SPDX-License-Identifier: BSD-3-Clause
// Runs one odometry plugin without a pipeline: context, frames in, motions with all revisions out.
#pragma once

#include <stdexcept>
#include <utility>
#include <vector>

#include "support/context.hpp"
#include "tolman/roles.hpp"

namespace tolman::test {

template <class Plugin>
class OdometryHost {
 public:
  /// Configures a Plugin that is constructed from `arguments`.
  template <class... Arguments>
  explicit OdometryHost(const CameraRig& rig, ParameterValues values = {}, Arguments... arguments)
      : services_(std::move(values), 7), plugin_(arguments...) {
    services_.rig = rig;
    configured_ = plugin_.configure(services_);
  }

  Plugin& plugin() { return plugin_; }
  Status configured() const { return configured_; }
  const std::vector<std::string>& log() const { return services_.log; }

  /// The plugin's answer; throws when it is a failure or holds NaN or infinity.
  Motion track(const Frame& frame) {
    Motion motion;
    const Status status = plugin_.track(frame, motion);
    if (!status.isOk()) throw std::runtime_error(status.message());
    if (!firstInvalidField(motion).empty()) throw std::runtime_error(firstInvalidField(motion));
    motions_.push_back(motion.T_previous_current);
    apply(motion.revisions);
    return motion;
  }

  void finish() {
    std::vector<MotionRevision> revisions;
    const Status status = plugin_.finish(revisions);
    if (!status.isOk()) throw std::runtime_error(status.message());
    apply(revisions);
  }

  /// All motions with the revisions so far.
  const std::vector<Eigen::Isometry3d>& motions() const { return motions_; }

  /// Poses from the first frame on.
  std::vector<Eigen::Isometry3d> trajectory() const {
    std::vector<Eigen::Isometry3d> poses;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (const Eigen::Isometry3d& motion : motions_) poses.push_back(pose = pose * motion);
    return poses;
  }

  /// Length of the trajectory, m.
  double length() const {
    double metres = 0;
    for (const Eigen::Isometry3d& motion : motions_) metres += motion.translation().norm();
    return metres;
  }

 private:
  void apply(const std::vector<MotionRevision>& revisions) {
    for (const MotionRevision& revision : revisions) {
      motions_.at(static_cast<std::size_t>(revision.frame)) = revision.T_previous_current;
    }
  }

  TestContext services_;
  Plugin plugin_;
  Status configured_;
  std::vector<Eigen::Isometry3d> motions_;
};

}  // namespace tolman::test
