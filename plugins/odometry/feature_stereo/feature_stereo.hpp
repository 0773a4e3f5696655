// SPDX-License-Identifier: BSD-3-Clause
// Feature-based odometry of a stereo pair, or of one camera with depth images: tracks corners with
// Lucas-Kanade, estimates the pose by RANSAC over P3P, refines a window of keyframes, and reports
// motions and revisions in m and rad.
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
#include "window.hpp"

namespace tolman::feature_stereo {

class FeatureOdometry : public Odometry {
 public:
  /// Where the disparities of corners come from.
  enum class DisparityFrom : std::uint8_t { RightImage, DepthImage };
  explicit FeatureOdometry(DisparityFrom origin) : origin_(origin) {}

  Status configure(const Context& context) override;
  Status reset() override;
  Status track(const Frame& frame, Motion& motion) override;
  Status finish(std::vector<MotionRevision>& revisions) override;

  /// Estimated offset of all disparities, px.
  double disparityOffset() const { return window_.disparityOffset(); }

 private:
  /// A landmark that is tracked from frame to frame.
  struct Track {
    std::int64_t landmark = -1;
    cv::Point2f pixel;           ///< in the last frame that was tracked
    cv::Point2f keyframe_pixel;  ///< in the last keyframe that saw it
    float disparity = kNoDisparity;
  };
  /// A corner with a disparity that is not a landmark yet.
  struct StereoCorner {
    cv::Point2f pixel;
    float disparity = kNoDisparity;
  };
  /// What is known of the current frame.
  struct Views {
    FlowPyramid left;
    FlowPyramid right;                  ///< DisparityFrom::RightImage
    const NamedArray* depth = nullptr;  ///< DisparityFrom::DepthImage; null: none to be used
  };
  struct Tracked {
    PoseEstimate pose;
    std::vector<Track> tracks;  ///< tracks that agree with the pose
    std::size_t attempted = 0;  ///< number of tracks that were searched for
  };

  Status readParameters(const ParameterValues& values);
  void useSettings();
  bool needsPair() const { return origin_ == DisparityFrom::RightImage; }
  /// Warns where a fault of the depth images begins.
  void tellDepth(FreshDepth::Kind kind, const Motion& motion);
  /// Whether the frame can be tracked: fills the views of images. False for images without
  /// contrast.
  bool lookAt(const Frame& frame);
  /// The disparity of each corner of the left view, or kNoDisparity; `guesses` as for
  /// matchStereo().
  std::vector<float> disparitiesOf(const Views& views, const std::vector<cv::Point2f>& corners,
                                   const std::vector<float>& guesses) const;
  /// Pose under constant velocity.
  Eigen::Isometry3d predictPose(double dt) const;
  std::optional<Tracked> trackFrom(const Views& views, const Eigen::Isometry3d& guess);
  std::optional<Tracked> trackAny(const Views& views, const Eigen::Isometry3d& predicted);
  std::vector<StereoCorner> findCandidates(const Views& views,
                                           const std::vector<Track>& tracks) const;
  bool wantsKeyframe() const;
  /// Adds a keyframe; returns its refined pose.
  Eigen::Isometry3d makeKeyframe(const Keyframe& keyframe,
                                 const std::vector<StereoCorner>& candidates);
  void publishPoints(Motion& motion);
  /// For the history: a function from the frame index of a keyframe to its pose.
  auto findKeyframe() const {
    return [this](std::int64_t frame) -> std::optional<Eigen::Isometry3d> {
      for (const Keyframe& keyframe : window_.keyframes()) {
        if (keyframe.frame == frame) return keyframe.T_world_camera;
      }
      return std::nullopt;
    };
  }
  /// Adds the motion's frame to the history, relative to this keyframe; returns its motion.
  Eigen::Isometry3d remember(const Eigen::Isometry3d& T_world_camera, const Keyframe& keyframe,
                             const Motion& motion);

  /// `views`: null when an image is missing or has no contrast.
  void answer(const Views* views, Motion& motion);
  void answerMeasured(const Views& views, Tracked&& tracked, Motion& motion);
  void answerPredicted(Motion& motion);
  /// Starts a new window at the predicted pose.
  void restart(const Views& views, Motion& motion);
  /// Makes the current left image the reference of the next frame.
  void keepImage(const Eigen::Isometry3d& T_world_camera);

  DisparityFrom origin_;
  Parameters parameters_;
  double depth_noise_ = 0;  ///< 1/m
  TrackSettings track_settings_;
  StereoSettings stereo_settings_;
  CornerSettings corner_settings_;
  PnpSettings pnp_settings_;
  RefinementSettings refinement_settings_;
  CameraRig rig_;
  Logger* log_ = nullptr;
  std::uint64_t seed_ = 0;

  // State that reset() clears.
  RandomStream random_{0};
  Window window_;
  MotionHistory<> history_;
  Views views_;                ///< of the current frame
  FlowPyramid reference_;      ///< left image of the last frame that was tracked
  std::vector<Track> tracks_;  ///< in that image
  Eigen::Isometry3d T_world_reference_ = Eigen::Isometry3d::Identity();
  Vector6d velocity_ = Vector6d::Zero();  ///< twist per second, of the last measured motion
  std::int64_t last_stamp_ns_ = -1;       ///< -1 before the first frame
  std::int64_t first_lost_ = -1;          ///< frame index; -1 while tracking
  int lost_frames_ = 0;
  double lost_s_ = 0;  ///< s, duration of the predicted motions since first_lost_
  FreshDepth fresh_depth_;
  bool told_depth_ = false;          ///< the fault that there is now
  std::size_t keyframe_tracks_ = 0;  ///< number of tracks at the last keyframe
};

// The two plugins of feature-based odometry.

/// Of a calibrated, rectified stereo pair.
class FeatureStereo final : public FeatureOdometry {
 public:
  using Parameters = feature_stereo::Parameters;
  FeatureStereo() : FeatureOdometry(DisparityFrom::RightImage) {}
};

/// Of a calibrated camera with depth images that are registered to it. A right image is not used.
class FeatureRgbd final : public FeatureOdometry {
 public:
  using Parameters = RgbdParameters;
  FeatureRgbd() : FeatureOdometry(DisparityFrom::DepthImage) {}
};

}  // namespace tolman::feature_stereo
