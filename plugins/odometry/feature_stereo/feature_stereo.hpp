// SPDX-License-Identifier: BSD-3-Clause
// The plugin: from stereo frames to motions, keyframes and revisions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "corner_detection.hpp"
#include "parameters.hpp"
#include "pnp.hpp"
#include "stereo_matching.hpp"
#include "tolman/roles.hpp"
#include "tracking.hpp"
#include "trajectory.hpp"
#include "window.hpp"
#include "window_refinement.hpp"

namespace tolman::feature_stereo {

class FeatureStereo final : public Odometry {
 public:
  using Parameters = feature_stereo::Parameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status track(const Frame& frame, Motion& motion) override;
  Status finish(std::vector<MotionRevision>& revisions) override;

  /// What the disparities are believed to be off by, px.
  double disparityOffset() const { return window_.disparityOffset(); }

 private:
  /// A landmark that is being followed.
  struct Track {
    std::int64_t landmark = -1;
    cv::Point2f pixel;           ///< in the last frame that was tracked
    cv::Point2f keyframe_pixel;  ///< in the last keyframe that saw it
    float disparity = kNoDisparity;
  };
  /// A corner with a disparity that is no landmark yet.
  struct Candidate {
    cv::Point2f pixel;
    float disparity = kNoDisparity;
  };
  struct StereoPyramids {
    Pyramid left;
    Pyramid right;
  };
  struct Tracked {
    PoseEstimate pose;
    std::vector<Track> tracks;  ///< those that agree with the pose
    std::size_t offered = 0;    ///< how many were looked for
  };

  Status checkRig() const;
  Status checkFrame(const Frame& frame) const;
  void useSettings();
  /// The pose when the camera goes on as before.
  Eigen::Isometry3d predictPose(double dt) const;
  std::optional<Tracked> trackFrom(const StereoPyramids& images, const Eigen::Isometry3d& guess);
  std::optional<Tracked> trackAny(const StereoPyramids& images, const Eigen::Isometry3d& predicted);
  std::vector<Candidate> findCandidates(const StereoPyramids& images,
                                        const std::vector<Track>& tracks) const;
  bool wantsKeyframe() const;
  /// A keyframe here; returns its refined pose.
  Eigen::Isometry3d makeKeyframe(const Keyframe& keyframe,
                                 const std::vector<Candidate>& candidates);
  void publishPoints(Motion& motion);

  void answer(const std::optional<StereoPyramids>& images, Motion& motion);
  void answerMeasured(const StereoPyramids& images, Tracked&& tracked, Motion& motion);
  void answerPredicted(Motion& motion);
  /// A new window here, where the camera is believed to be.
  void restart(const StereoPyramids& images, Motion& motion);

  Parameters parameters_;
  TrackSettings track_settings_;
  StereoSettings stereo_settings_;
  CornerSettings corner_settings_;
  PnpSettings pnp_settings_;
  RefinementSettings refinement_settings_;
  CameraRig rig_;
  Logger* log_ = nullptr;
  std::uint64_t seed_ = 0;

  // All that decides the future, beside the above.
  RandomStream random_{0};
  Window window_;
  Trajectory trajectory_;
  Pyramid reference_;          ///< left image of the last frame that was tracked
  std::vector<Track> tracks_;  ///< in that image
  Eigen::Isometry3d T_world_reference_ = Eigen::Isometry3d::Identity();
  Vector6d velocity_ = Vector6d::Zero();  ///< twist per second, of the last measured motion
  std::int64_t last_stamp_ns_ = -1;       ///< -1 before the first frame
  std::int64_t first_lost_ = -1;          ///< frame index; -1 while tracking
  int lost_frames_ = 0;
  std::size_t keyframe_tracks_ = 0;  ///< how many the last keyframe began with
};

}  // namespace tolman::feature_stereo
