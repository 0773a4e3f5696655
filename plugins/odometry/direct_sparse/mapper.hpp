// SPDX-License-Identifier: BSD-3-Clause
// Maintains the window: adds keyframes, activates candidates, runs the bundle adjustment and
// marginalises old points and keyframes; other frames refine the depths of candidates.
#pragma once

#include <cstdint>

#include "activation.hpp"
#include "bundle_adjustment.hpp"
#include "disparity_field.hpp"
#include "point_selection.hpp"
#include "row_alignment.hpp"
#include "static_stereo.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

/// DirectSparse::configure() sets most of them from the parameters, whose defaults are different.
struct MapperSettings {
  int points = 2000;        ///< in the window
  int candidates = 1500;    ///< per keyframe
  int window = 7;           ///< keyframes
  int max_disparity = 160;  ///< px
  /// Of marginalised points in the prior; as DSO, compared on KITTI 06, raw 0001, town 07.
  double marginal_weight = 0.25;
  double offset_sigma = 0;          ///< px, 0: the disparity offset is not estimated
  double column_sigma = 0;          ///< px, 0: only an offset of the disparities is estimated
  double calibration_distance = 0;  ///< m, 0: an offset is never compensated
  double row_sigma = 0;             ///< px, 0: errors of the rows are not estimated
  AdjustmentSettings adjustment;
};

class Mapper {
 public:
  void configure(const CameraRig& rig, const MapperSettings& settings);
  /// Removes the window; what was learnt of the cameras stays.
  void reset();
  /// Forgets the errors of rows, and whether there is a field of disparity errors. Before reset().
  void forgetCameras();
  /// Rows of right images, which rows().correct() must have corrected before they are given.
  RowAlignment& rows() { return rows_; }
  const RowAlignment& rows() const { return rows_; }

  Window& window() { return window_; }
  const Window& window() const { return window_; }

  /// Swaps the pyramids with the buffers of a removed keyframe, to reuse memory. `right` may be
  /// empty (covered camera). The oldest keyframe of the window fixes the gauge. Returns the number
  /// of points in the window.
  std::size_t addKeyframe(std::int64_t frame, const Eigen::Isometry3d& T_world_camera,
                          const Affine& affine, ImagePyramid& left, ImagePyramid& right);
  /// The first keyframe of a single camera, with assumed depths for this camera height (m). The
  /// next addKeyframe() replaces its points by those whose depths observe() has found.
  void draftKeyframe(std::int64_t frame, const Eigen::Isometry3d& T_world_camera,
                     double camera_height, ImagePyramid& left);
  bool isDraft() const { return draft_; }
  /// Result of the bundle adjustment at the last keyframe.
  const AdjustmentResult& adjustment() const { return adjustment_; }
  /// Refines the candidates of all keyframes with a frame of known pose.
  void observe(const Eigen::Isometry3d& T_world_camera, const Affine& affine,
               const ImagePyramid& left);
  /// Checks a frame that was tracked at this pose, see stereo_check.hpp.
  StereoAgreement compareWithStereo(const Eigen::Isometry3d& T_world_camera,
                                    const ImagePyramid& left, const ImagePyramid& right) const {
    return direct_sparse::compareWithStereo(rig_, window_, T_world_camera, left.level(0),
                                            right.level(0), settings_.max_disparity);
  }

 private:
  Keyframe& insert(std::int64_t frame, const Eigen::Isometry3d& T_world_camera,
                   const Affine& affine, ImagePyramid& left);
  void setFieldPrior();
  void selectCandidates(Keyframe& keyframe);
  void matchCandidates(Keyframe& keyframe);
  void collectGreyPairs(const Keyframe& keyframe);
  /// Brightness of the right image, from all pixels of matched patterns.
  void balanceRight(Keyframe& keyframe, const StereoSearch& search);
  void learnRows(const Keyframe& keyframe, float gain);
  /// More steps for a single camera whose window is not full yet: it is far from its optimum.
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
  RowAlignment rows_;
  FieldDecision decision_;
  std::vector<std::optional<StereoMatch>> matches_;
  std::vector<RowCorner> corners_;
  struct GreyPair {
    float left = 0;
    float right = 0;
  };
  std::vector<GreyPair> grey_pairs_;  ///< grey levels of matched pixels
  Keyframe observed_frame_;           ///< pose and brightness of the frame that is observed
};

}  // namespace tolman::direct_sparse
