// SPDX-License-Identifier: BSD-3-Clause
// Odometry with checks of its images and of its motions.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/frame_check.hpp"
#include "engine/motion_check.hpp"
#include "engine/predicted_span.hpp"
#include "host/stages.hpp"

namespace tolman::pipeline {

/// The last motion, as a prediction for a frame without an answer.
Motion predictedMotion(const Frame& frame, const Motion& last);

/// Answers of odometry that are impossible for the robot; empty: none.
struct Impossible {
  std::string motion;    ///< why the motion was replaced
  std::string revision;  ///< the first revision that was left out, and why
};

class CheckedOdometry {
 public:
  CheckedOdometry(host::OdometryStage& odometry, const config::CheckSettings& settings)
      : odometry_(odometry), check_images_(settings.images), motion_check_(settings) {}

  /// Checks the images of a frame (see imaging::FrameCheck); returns a note where a fault begins.
  /// Frames must come in order, one call at a time; track() may still work on an earlier one.
  std::optional<std::string> admit(Frame& frame);

  /// Replaces an impossible motion by a prediction, and leaves out impossible revisions: an
  /// odometry that tracks a moving object may report wrong motions with a small covariance.
  Status track(const Frame& frame, Motion& motion, Impossible& impossible);

  Status finish(std::vector<MotionRevision>& revisions, Impossible& impossible);

 private:
  /// A motion that may be revised.
  struct Answered {
    std::int64_t frame = -1;
    double dt = 0;  ///< s
    bool scale_known = true;
  };
  void remember(const Motion& motion);
  void filter(std::vector<MotionRevision>& revisions, std::string& impossible) const;
  std::optional<std::string> reasonAgainst(const MotionRevision& revision) const;

  host::OdometryStage& odometry_;
  bool check_images_;
  imaging::FrameCheck frame_check_;
  MotionCheck motion_check_;
  PredictedSpan predicted_;
  Motion last_;
  std::vector<Answered> answered_;   ///< of all frames so far, in order
  std::set<std::int64_t> replaced_;  ///< frames with an impossible motion
};

}  // namespace tolman::pipeline
