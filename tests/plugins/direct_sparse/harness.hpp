// SPDX-License-Identifier: BSD-3-Clause
// A host for one odometry instance: services, frames in, final motions out.
#pragma once

#include <string>
#include <vector>

#include "direct_sparse.hpp"
#include "support/context.hpp"

namespace tolman::test {

class Host {
 public:
  explicit Host(const CameraRig& rig, ParameterValues values = {},
                direct_sparse::Cameras cameras = direct_sparse::Cameras::Stereo);

  direct_sparse::DirectSparse& plugin() { return plugin_; }
  Status configured() const { return configured_; }
  const std::vector<std::string>& log() const { return services_.log; }
  /// The plugin's answer, found sound; throws when it is a failure.
  Motion track(const Frame& frame);
  void finish();
  /// Poses from the first frame on, as the last revisions have them.
  std::vector<Eigen::Isometry3d> trajectory() const;
  double length() const;

 private:
  void apply(const std::vector<MotionRevision>& revisions);

  TestContext services_;
  direct_sparse::DirectSparse plugin_;
  Status configured_;
  std::vector<Eigen::Isometry3d> motions_;
};

/// The frame, as the one of another index at 10 Hz.
Frame again(const Frame& frame, std::int64_t index);

/// An image of one grey level, of the street's size.
Image filled(int grey);

/// Each grey level changed to gain * level + offset, cut off at 0 and 255.
Image changed(const Image& image, double gain, double offset);

}  // namespace tolman::test
