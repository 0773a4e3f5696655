// SPDX-License-Identifier: BSD-3-Clause
// What an odometry of calibrated cameras requires of the rig and of each frame.
#pragma once

#include <string>

#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman {

/// Unsupported if the cameras are not calibrated or, where a pair is needed, not a stereo pair.
inline Status requireCalibrated(const CameraRig& rig, bool needs_pair) {
  if (rig.calibrated && (!needs_pair || rig.isStereo())) return Status::ok();
  return Status::unsupported(std::string("the cameras are ") +
                             (rig.calibrated ? "not a stereo pair" : "not calibrated") +
                             "; use an odometry plugin for such cameras, or a source of "
                             "calibrated, rectified stereo images");
}

/// Unsupported for a left image without the right one, where a pair is needed and the source
/// reports no defect; InvalidInput for an image of another size than its calibration.
inline Status requireImages(const Frame& frame, const CameraRig& rig, bool needs_pair) {
  if (needs_pair && !frame.left.empty() && frame.right.empty() && frame.defect.empty()) {
    return Status::unsupported(
        "the frame has no right image; use a monocular odometry plugin, or a stereo source");
  }
  for (const Image* image : {&frame.left, &frame.right}) {
    if (image->empty() || (image->width() == rig.width && image->height() == rig.height)) continue;
    return Status::invalidInput("the image has " + std::to_string(image->width()) + "x" +
                                std::to_string(image->height()) + " pixels, its calibration " +
                                std::to_string(rig.width) + "x" + std::to_string(rig.height) +
                                "; give images as they were calibrated");
  }
  return Status::ok();
}

/// The largest disparity that is searched for, px: an eighth of the image's width. Chosen on
/// KITTI 06, where it is that of 2.5 m; judged on a camera in a hand (0.37 m) and a hall.
inline double largestDisparity(const CameraRig& rig) { return rig.width / 8.0; }

}  // namespace tolman
