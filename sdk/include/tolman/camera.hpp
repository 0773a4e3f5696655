// SPDX-License-Identifier: BSD-3-Clause
// Camera models: a pinhole, and the rectified stereo (or single) rig of a run.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "tolman/fields.hpp"

namespace tolman {

/// An undistorted pinhole camera. Pixel centres are at integer coordinates.
struct Pinhole {
  double fx = 0;  ///< px
  double fy = 0;  ///< px
  double cx = 0;  ///< px
  double cy = 0;  ///< px

  /// Camera point (z > 0) to pixel.
  Eigen::Vector2d project(const Eigen::Vector3d& p) const {
    return {fx * p.x() / p.z() + cx, fy * p.y() / p.z() + cy};
  }
  /// Pixel to the point of its ray with z = 1.
  Eigen::Vector3d ray(const Eigen::Vector2d& pixel) const {
    return {(pixel.x() - cx) / fx, (pixel.y() - cy) / fy, 1.0};
  }
};

/// The cameras of a source. Constant over a run.
///
/// With two cameras the pair is rectified: same image size and pinhole, rows aligned, and the right
/// camera sits at (+baseline, 0, 0) of the left one, so that disparity = u_left - u_right
/// = fx * baseline / z >= 0. A source with other data must rectify them or refuse.
struct CameraRig {
  static constexpr const char* kRecord = "camera";
  int width = 0;            ///< px; 0 when the source has no images (a motion log)
  int height = 0;           ///< px
  bool calibrated = false;  ///< fx, fy, cx, cy are known
  Pinhole pinhole;
  double baseline = 0;  ///< m, > 0 for stereo, 0 for a single camera

  bool isStereo() const { return baseline > 0; }

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(width, "px", "image width");
    TOLMAN_FIELD(height, "px", "image height");
    TOLMAN_FIELD(calibrated, "", "whether the pinhole is known");
    TOLMAN_FIELD(pinhole.fx, "px", "focal length, horizontal");
    TOLMAN_FIELD(pinhole.fy, "px", "focal length, vertical");
    TOLMAN_FIELD(pinhole.cx, "px", "principal point, horizontal");
    TOLMAN_FIELD(pinhole.cy, "px", "principal point, vertical");
    TOLMAN_FIELD(baseline, "m", "distance of the right camera; 0 for a single one");
  }
};

}  // namespace tolman
