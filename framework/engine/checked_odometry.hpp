// SPDX-License-Identifier: BSD-3-Clause
// Odometry with checks of its images and of its motions.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "config/settings.hpp"
#include "engine/camera_check.hpp"
#include "host/stages.hpp"

namespace tolman::engine {

/// The last motion, as a prediction for a frame without an answer.
Motion predictedMotion(const Frame& frame, const Motion& last);

/// Whether the motions of odometry are possible for the robot: speed, change of speed, turn rate.
class MotionCheck {
 public:
  explicit MotionCheck(const config::CheckSettings& settings) : settings_(settings) {}

  /// Call it with each motion, in order. Returns why a motion in state Tracking is impossible; none
  /// if it is possible. If the scale is unknown, only the turn rate is checked.
  std::optional<std::string> check(const Motion& motion);
  /// The same for a revision of an earlier motion over `dt` s. Only speed and turn rate are
  /// checked, because neighbouring motions may be revised as well.
  std::optional<std::string> checkRevision(const MotionRevision& revision, double dt,
                                           bool scale_known) const;

 private:
  std::optional<std::string> tooFast(const Eigen::Isometry3d& moved, double dt,
                                     bool scale_known) const;

  config::CheckSettings settings_;
  std::optional<double> speed_;  ///< of the last possible motion, m/s
  double since_ = 0;             ///< s since that motion
};

/// The motion that was predicted for the frames at which odometry failed.
///
/// An odometry that failed at a frame may return its next motion relative to the last frame that it
/// answered; the `dt` of that motion spans both. The trajectory already contains the prediction for
/// the frames between, so it is subtracted from that motion and from later revisions of it:
/// prediction and remaining motion composed are the motion that odometry measured.
class PredictedSpan {
 public:
  /// Odometry failed at a frame; `prediction` is recorded instead of its answer.
  void add(const Motion& prediction);
  /// Odometry answered with `motion`. Subtracts the predictions if it spans them.
  void subtractFrom(Motion& motion);
  /// The same for a revision of such a motion.
  void subtractFrom(MotionRevision& revision) const;

 private:
  Eigen::Isometry3d T_answered_given_ = Eigen::Isometry3d::Identity();  ///< predicted
  bool predicted_ = false;                                              ///< since the last answer
  std::int64_t given_ns_ = 0;                                           ///< of the last frame
  std::int64_t answered_ns_ = 0;                                        ///< of the last answer
  /// Removed predictions by the frame of the motion that spanned them.
  std::map<std::int64_t, Eigen::Isometry3d> subtracted_;
};

class CheckedOdometry {
 public:
  CheckedOdometry(host::OdometryStage& odometry, const config::CheckSettings& settings)
      : odometry_(odometry), check_images_(settings.images), motion_check_(settings) {}

  const host::Instance& instance() const { return odometry_.instance(); }
  /// Checks the images of a frame (see FrameCheck); returns their fault. Frames must come in order,
  /// one call at a time; track() may still work on an earlier one.
  std::optional<std::string> admit(Frame& frame) {
    return check_images_ ? frame_check_.check(frame) : std::nullopt;
  }

  /// Replaces a motion that is impossible for the robot by a prediction, and leaves out such
  /// revisions: an odometry that tracks a moving object may report wrong motions with a small
  /// covariance. `impossible` says why: of the motion, and of the first of the revisions.
  Status track(const Frame& frame, Motion& motion, std::vector<std::string>& impossible);
  Status finish(std::vector<MotionRevision>& revisions, std::vector<std::string>& impossible);

 private:
  /// A motion that may be revised.
  struct Answered {
    std::int64_t frame = -1;
    double dt = 0;  ///< s
    bool scale_known = true;
  };
  void remember(const Motion& motion);
  void filter(std::vector<MotionRevision>& revisions, std::vector<std::string>& impossible) const;

  host::OdometryStage& odometry_;
  bool check_images_;
  FrameCheck frame_check_;
  MotionCheck motion_check_;
  PredictedSpan predicted_;
  Motion last_;
  std::vector<Answered> answered_;   ///< of all frames so far, in order
  std::set<std::int64_t> replaced_;  ///< frames with an impossible motion
};

}  // namespace tolman::engine
