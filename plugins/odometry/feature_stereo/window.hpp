// SPDX-License-Identifier: BSD-3-Clause
// The active window: the last keyframes and the landmarks that they observed.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "projection.hpp"

namespace tolman::feature_stereo {

/// A landmark seen by a keyframe.
struct Observation {
  std::int64_t keyframe = -1;               ///< its frame index
  StereoPixel pixel = StereoPixel::Zero();  ///< as measured, with the disparity offset
  bool has_disparity = false;               ///< false: pixel.z() is a prediction
};

struct Landmark {
  InverseDepthPoint point;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the coordinates, with fixed poses
  std::vector<Observation> observations;                 ///< by keyframes of the window
};

struct Keyframe {
  std::int64_t frame = -1;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
};

class Window {
 public:
  /// Removes keyframes and landmarks; keeps the disparity offset.
  void clear();
  void addKeyframe(const Keyframe& keyframe) { keyframes_.push_back(keyframe); }
  /// Removes the oldest keyframe, its observations, and landmarks without other observations.
  void dropOldest();
  /// Removes landmarks without observations.
  void dropUnseen();

  /// A new landmark, seen by the latest keyframe; returns its id.
  std::int64_t addLandmark(const Landmark& landmark);
  Landmark* find(std::int64_t id);
  /// Place among keyframes() of the keyframe of this frame, which must be one of them.
  std::size_t indexOf(std::int64_t frame) const;

  std::deque<Keyframe>& keyframes() { return keyframes_; }
  const std::deque<Keyframe>& keyframes() const { return keyframes_; }
  std::map<std::int64_t, Landmark>& landmarks() { return landmarks_; }
  const std::map<std::int64_t, Landmark>& landmarks() const { return landmarks_; }
  /// Measured minus true disparity, px, an error of the rectification.
  double disparityOffset() const { return disparity_offset_; }
  void setDisparityOffset(double offset) { disparity_offset_ = offset; }

 private:
  std::deque<Keyframe> keyframes_;              ///< oldest first
  std::map<std::int64_t, Landmark> landmarks_;  ///< by id, so that the order is deterministic
  std::int64_t next_id_ = 0;
  double disparity_offset_ = 0;
};

// Bundle adjustment of the active window.

struct RefinementSettings {
  PixelNoise noise;
  int iterations = 6;         ///< three are worse where KITTI 06 is blurred
  double offset_sigma = 0.2;  ///< px, prior standard deviation of the disparity offset
  /// px, standard deviation of its change per keyframe; chosen, not tuned
  double offset_drift = 0.01;
};

/// Minimises the reprojection errors over keyframe poses (the oldest is fixed), landmarks and the
/// disparity offset, then removes outlying observations and updates the covariances of landmarks.
/// Single-threaded, with sums in a fixed order: the same window gives the same bits.
void refineWindow(const CameraRig& rig, const RefinementSettings& settings, Window& window);

}  // namespace tolman::feature_stereo
