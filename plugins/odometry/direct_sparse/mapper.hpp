// SPDX-License-Identifier: BSD-3-Clause
// The window's life: a keyframe comes in, candidates become points, the window is adjusted, old
// points and keyframes are marginalised; frames in between refine candidates.
#pragma once

#include <cstdint>

#include "activation.hpp"
#include "bundle_adjustment.hpp"
#include "point_selection.hpp"
#include "static_stereo.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

struct MapperSettings {
  int points = 2000;
  int candidates = 1500;
  int window = 7;
  int max_disparity = 160;  ///< px
  double marginal_weight = 0.06;
  double offset_sigma = 0;  ///< px, 0: the disparity offset is held
  AdjustmentSettings adjustment;
};

class Mapper {
 public:
  void configure(const CameraRig& rig, const MapperSettings& settings);
  void reset();

  Window& window() { return window_; }
  const Window& window() const { return window_; }

  /// Takes the pyramids (swaps its own old ones in). `right` may be empty: a covered camera.
  /// The oldest keyframe of the window holds the gauge. Returns the points in the window.
  std::size_t addKeyframe(std::int64_t frame, const Eigen::Isometry3d& T_world_camera,
                          const Affine& affine, Pyramid& left, Pyramid& right);
  /// The first keyframe of a single camera, with a drafted scene of this camera height. The next
  /// addKeyframe() replaces the draft by the depths that observe() has found.
  void draftKeyframe(std::int64_t frame, const Eigen::Isometry3d& T_world_camera,
                     double camera_height, Pyramid& left);
  bool isDraft() const { return draft_; }
  /// How the window was adjusted to the last keyframe.
  const AdjustmentResult& adjustment() const { return adjustment_; }
  /// Refines the candidates of all keyframes with a frame of known pose.
  void observe(const Eigen::Isometry3d& T_world_camera, const Affine& affine, const Pyramid& left);

 private:
  Keyframe& insert(std::int64_t frame, const Eigen::Isometry3d& T_world_camera,
                   const Affine& affine, Pyramid& left);
  void holdOffset();
  void selectCandidates(Keyframe& keyframe);
  void matchCandidates(Keyframe& keyframe);
  void balanceRight(Keyframe& keyframe, const StereoSearch& search) const;
  /// A young window of a single camera is far from its optimum: it gets more steps.
  AdjustmentSettings adjustmentFor(const Keyframe& keyframe) const;
  void shrink();

  CameraRig rig_;
  MapperSettings settings_;
  Window window_;
  bool draft_ = false;
  AdjustmentResult adjustment_;
  PointSelector selector_;
  Activator activator_;
  LinearSystem system_;
  std::vector<std::optional<StereoMatch>> matches_;
  Keyframe observer_;  ///< pose and brightness of the frame that is observed
};

}  // namespace tolman::direct_sparse
