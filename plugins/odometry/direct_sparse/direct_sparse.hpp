// SPDX-License-Identifier: BSD-3-Clause
// The plugin: from frames to motions, keyframes and revisions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mapper.hpp"
#include "parameters.hpp"
#include "tolman/roles.hpp"
#include "tracker.hpp"
#include "trajectory.hpp"

namespace tolman::direct_sparse {

enum class Cameras : std::uint8_t { Stereo, Single };

class DirectSparse : public Odometry {
 public:
  explicit DirectSparse(Cameras cameras) : cameras_(cameras) {}
  Status configure(const Context& context) override;
  Status reset() override;
  Status track(const Frame& frame, Motion& motion) override;
  Status finish(std::vector<MotionRevision>& revisions) override;

  /// What the disparities are believed to be off by, px.
  double disparityOffset() const { return mapper_.window().offset.value(); }

 private:
  Status checkRig() const;
  Status checkFrame(const Frame& frame) const;
  /// Builds current_ (and right_ where the image shows something); false when it shows nothing.
  bool look(const Frame& frame);

  void answer(bool visible, const Frame& frame, Motion& motion);
  /// A frame and the depths that it shows, in turns: neither is known before the other.
  std::optional<AlignmentResult> trackDraft(Expectation expectation);
  Eigen::Isometry3d poseOf(const AlignmentResult& tracked) const;
  void answerMeasured(const AlignmentResult& tracked, const Frame& frame, Motion& motion);
  /// While the scene is a draft, nothing is known of the motion; it is revised later.
  void answerDraft(Motion& motion);
  /// The frame rides on this keyframe.
  void answerPredicted(const Keyframe& keyframe, Motion& motion);
  void restart(const Frame& frame, Motion& motion);
  Expectation expect(double dt) const;
  bool wantsKeyframe(const AlignmentResult& tracked) const;
  /// False when the window that came out is not to be believed; then only restart() may follow.
  bool makeKeyframe(const Frame& frame, const Eigen::Isometry3d& T_world_camera,
                    const Affine& affine, Motion& motion);
  /// The window has come apart: lost, and a new one starts from this frame.
  void abandonWindow(const Frame& frame, Motion& motion);
  void lookRight(const Frame& frame);
  Matrix6d motionCovariance(const AlignmentResult& tracked,
                            const Eigen::Isometry3d& T_previous_current);
  void publishPoints(Motion& motion) const;

  Cameras cameras_;
  Parameters parameters_;
  CameraRig rig_;
  Logger* log_ = nullptr;

  // All that decides the future, beside the above.
  Mapper mapper_;
  Tracker tracker_;
  Trajectory trajectory_;
  Pyramid current_;
  Pyramid right_;
  Affine brightness_;                            ///< of the last measured frame
  Affine reference_brightness_;                  ///< against the reference
  Vector6d velocity_ = Vector6d::Zero();         ///< twist per second, of the last measured motion
  Matrix6d pose_covariance_ = Matrix6d::Zero();  ///< of the last frame against its keyframe
  bool has_velocity_ = false;
  bool can_track_ = false;
  std::int64_t last_stamp_ns_ = -1;  ///< -1 before the first frame
  std::int64_t first_lost_ = -1;     ///< frame index; -1 while tracking
  int lost_frames_ = 0;
  int draft_frames_ = 0;  ///< that were tracked against a drafted scene
  bool known_ = false;    ///< some scene was no draft
  int unrecognised_ = 0;  ///< frames in a row that show something, but not the reference
};

}  // namespace tolman::direct_sparse
