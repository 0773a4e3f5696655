// SPDX-License-Identifier: BSD-3-Clause
// A host for one odometry instance: services, frames in, final motions out.
#pragma once

#include <string>
#include <vector>

#include "feature_stereo.hpp"
#include "support/context.hpp"

namespace tolman::test {

class Host {
 public:
  explicit Host(const CameraRig& rig, ParameterValues values = {});

  feature_stereo::FeatureStereo& plugin() { return plugin_; }
  /// The plugin's answer; throws when it is a failure.
  Motion track(const Frame& frame);
  Status configured() const { return configured_; }
  void finish();
  /// All motions, as the last revisions have them.
  const std::vector<Eigen::Isometry3d>& motions() const { return motions_; }
  /// Poses from the first frame on.
  std::vector<Eigen::Isometry3d> trajectory() const;
  double length() const;

 private:
  void apply(const std::vector<MotionRevision>& revisions);

  TestContext services_;
  feature_stereo::FeatureStereo plugin_;
  Status configured_;
  std::vector<Eigen::Isometry3d> motions_;
};

}  // namespace tolman::test
