// SPDX-License-Identifier: BSD-3-Clause
// Whether static stereo of a frame agrees with the pose at which the frame was tracked. After a gap
// a frame may be aligned at a wrong place, where the pose predicts wrong depths.
#pragma once

#include "tolman/camera.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

/// Number of points of the window that are in the image of a frame, and number of those whose
/// disparity is the one that the pose T_world_camera of the frame predicts.
struct StereoAgreement {
  int compared = 0;  ///< points with a disparity of static stereo
  int agreeing = 0;
  /// At the right place nearly all agree: 115 of 117 on kitti_clips/06. At a wrong place only few
  /// points can be matched: 3 of 14 agreed on 01. Chosen on 06, on the town in
  /// traffic and on one fault of 01 (docs/report/odometry.md).
  bool confirms() const { return agreeing >= 20 && 2 * agreeing >= compared; }
};

/// At most some hundred points are compared. `max_disparity` (px) is as in StereoSearch.
StereoAgreement compareWithStereo(const CameraRig& rig, const Window& window,
                                  const Eigen::Isometry3d& T_world_camera, const GrayLevel& left,
                                  const GrayLevel& right, int max_disparity);

}  // namespace tolman::direct_sparse
