// SPDX-License-Identifier: BSD-3-Clause
// Projects points through the lens of a raw camera.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/status.hpp"

namespace tolman::engine {

class Lens {
 public:
  explicit Lens(const RawCamera& camera);

  /// The pixel of a point of the camera frame at any distance; it may be outside of the image. None
  /// behind the camera, and beyond the angle from which the polynomial of the distortion decreases:
  /// there it would map rays that the image does not show.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point) const;
  /// The same as project(), but none outside of the image.
  std::optional<Eigen::Vector2d> pixelOf(const Eigen::Vector3d& point) const;
  /// Pixels per unit of x/z at the centre of the image.
  double focal() const;
  /// Whether the camera is a pinhole without distortion.
  bool isPinhole() const;

 private:
  double distorted(double radius) const;
  Eigen::Vector2d distorted(const Eigen::Vector2d& p) const;

  RawCamera camera_;
  double limit_ = 0;  ///< radius, or angle for Equidistant, up to which the distortion grows
};

// Chooses the rectified cameras for raw ones: their rotations, and the rectangle of their common
// view that the images show.

struct ViewOptions {
  double scale = 1;           ///< pixels of the rectified image per raw pixel, at the centre
  double field_of_view = 90;  ///< deg; largest angle across and down if none is prescribed
};

struct RectifiedView {
  CameraRig rig;
  std::vector<Eigen::Matrix3d> R_rectified_raw;  ///< one for each raw camera
  bool is_identity = false;                      ///< the images are rectified already
};

/// The view that the calibration prescribes, else the largest rectangle that all cameras show
/// completely. Two cameras are rotated so that their x axes are along the baseline, and their
/// optical axes by equal angles towards each other. A failure says what is wrong in the
/// calibration, and what to do.
Result<RectifiedView> chooseView(const RawRig& raw, const ViewOptions& options);

/// "2 radial_tangential cameras of 752x480 px, rectified to 703x431 px, 73 x 50 deg"
std::string viewText(const RawRig& raw, const RectifiedView& view);

}  // namespace tolman::engine
