// SPDX-License-Identifier: BSD-3-Clause
// Direct sparse odometry for a rectified stereo pair (Wang et al., ICCV 2017) or a single camera
// (Engel et al., PAMI 2018): tracks each frame, adds keyframes and reports motions and revisions in
// m and rad. With one camera the scale is arbitrary.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lost_motion.hpp"
#include "mapper.hpp"
#include "parameters.hpp"
#include "tolman/roles.hpp"
#include "tracker.hpp"

namespace tolman::direct_sparse {

enum class Cameras : std::uint8_t { Stereo, Single };

class DirectSparse : public Odometry {
 public:
  explicit DirectSparse(Cameras cameras) : cameras_(cameras) {}
  Status configure(const Context& context) override;
  Status reset() override;
  Status track(const Frame& frame, Motion& motion) override;
  Status finish(std::vector<MotionRevision>& revisions) override;

  /// Estimated offset of all disparities, px.
  double disparityOffset() const { return mapper_.window().field.offset(); }

 private:
  Status checkRig() const;
  /// Builds current_; false when the image is missing or has no contrast.
  bool buildLeft(const Frame& frame);

  void answer(bool visible, const Frame& frame, Motion& motion);
  /// Single camera: alternates between tracking the frame and estimating depths from it.
  std::optional<AlignmentResult> trackDraft(Expectation expectation);
  std::optional<AlignmentResult> align(const Frame& frame, double dt);
  bool contradictsStereo(const AlignmentResult& tracked, const Frame& frame);
  bool isPlausible(const AlignmentResult& tracked, double dt) const;
  Eigen::Isometry3d poseOf(const AlignmentResult& tracked) const;
  void answerMeasured(const AlignmentResult& tracked, const Frame& frame, Motion& motion);
  /// Reports Initialising while depths are only assumed; the motion is revised later.
  void answerDraft(Motion& motion);
  /// Reports a predicted motion as Lost, relative to this keyframe.
  void answerPredicted(const Keyframe& keyframe, Motion& motion);
  void restart(const Frame& frame, Motion& motion);
  Expectation expect(double dt) const;
  bool wantsKeyframe(const AlignmentResult& tracked) const;
  /// False when the adjusted window is implausible; then restart() must follow.
  bool makeKeyframe(const Frame& frame, const Eigen::Isometry3d& T_world_camera,
                    const Affine& affine, Motion& motion);
  /// Reports Lost and starts a new window at this frame.
  void abandonWindow(const Frame& frame, Motion& motion);
  /// Builds right_; empty when the image is missing or has no contrast.
  void buildRight(const Frame& frame);
  /// For the history: a function from the frame index of a keyframe to its pose.
  auto findKeyframe() const {
    return [this](std::int64_t frame) -> std::optional<Eigen::Isometry3d> {
      const Keyframe* keyframe = mapper_.window().find(frame);
      if (keyframe == nullptr) return std::nullopt;
      return keyframe->T_world_camera();
    };
  }
  /// Adds the motion's frame to the history, relative to this keyframe; returns its motion.
  Eigen::Isometry3d remember(const Eigen::Isometry3d& T_world_camera, const Keyframe& keyframe,
                             const Motion& motion);
  Matrix6d motionCovariance(const AlignmentResult& tracked,
                            const Eigen::Isometry3d& T_previous_current);
  void publishPoints(Motion& motion) const;

  Cameras cameras_;
  Parameters parameters_;
  CameraRig rig_;
  Logger* log_ = nullptr;

  // State that reset() clears.
  Mapper mapper_;
  Tracker tracker_;
  MotionHistory<> history_;
  ImagePyramid current_;
  ImagePyramid right_;
  Affine brightness_;                            ///< of the last measured frame
  Affine reference_brightness_;                  ///< against the reference
  Vector6d velocity_ = Vector6d::Zero();         ///< twist per second, of the last measured motion
  RecentVelocities recent_velocities_;           ///< of measured motions, for lost ones
  Matrix6d pose_covariance_ = Matrix6d::Zero();  ///< of the last frame relative to its keyframe
  bool has_velocity_ = false;
  bool can_track_ = false;
  std::int64_t last_stamp_ns_ = -1;  ///< -1 before the first frame
  std::int64_t first_lost_ = -1;     ///< frame index; -1 while tracking
  double gap_s_ = 0;                 ///< s, duration of the predicted motions since then
  int lost_frames_ = 0;
  int draft_frames_ = 0;        ///< frames tracked against the assumed depths of the start
  bool had_keyframe_ = false;   ///< a keyframe with measured depths has existed
  int untracked_in_a_row_ = 0;  ///< frames in a row with contrast that could not be tracked
};

}  // namespace tolman::direct_sparse
