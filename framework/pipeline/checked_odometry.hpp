// SPDX-License-Identifier: BSD-3-Clause
// Odometry between two checks: of the images that it gets, and of the motions that it answers.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/stages.hpp"
#include "imaging/frame_check.hpp"
#include "pipeline/motion_check.hpp"

namespace tolman::pipeline {

/// The last motion, as a prediction for a frame without an answer.
Motion predictedMotion(const Frame& frame, const Motion& last);

class CheckedOdometry {
 public:
  CheckedOdometry(host::OdometryStage& odometry, const config::CheckSettings& settings)
      : odometry_(odometry), check_images_(settings.images), motion_check_(settings) {}

  /// Takes images with a fault out of a frame; returns a note where a fault begins. Frames come in
  /// order, one call at a time; track() may still work on an earlier one.
  std::optional<std::string> admit(Frame& frame);

  /// Replaces an impossible motion by a prediction; `impossible` becomes the reason, else empty.
  Status track(const Frame& frame, Motion& motion, std::string& impossible);

  Status finish(std::vector<MotionRevision>& revisions);

 private:
  void removeReplaced(std::vector<MotionRevision>& revisions) const;

  host::OdometryStage& odometry_;
  bool check_images_;
  imaging::FrameCheck frame_check_;
  MotionCheck motion_check_;
  Motion last_;
  std::set<std::int64_t> replaced_;  ///< frames with an impossible motion
};

}  // namespace tolman::pipeline
