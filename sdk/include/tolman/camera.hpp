// SPDX-License-Identifier: BSD-3-Clause
// Camera models: a pinhole, the rectified stereo (or single) rig of a run, and cameras with the
// distortion of their lenses, which the host rectifies.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

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
/// camera is at (+baseline, 0, 0) of the left one, so that disparity = u_left - u_right
/// = fx * baseline / z >= 0. A source with other data implements RawRigSource or refuses the data.
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

/// How a lens maps a point (x, y, z), in camera axes, to the pixel (fx a + cx, fy b + cy).
enum class LensModel : std::uint8_t {
  Pinhole,  ///< (a, b) = (x/z, y/z)
  /// (a, b) is (x/z, y/z) after radial and tangential distortion, with the coefficients k1 k2 p1 p2
  /// k3 k4 k5 k6 in OpenCV's order (plumb_bob: the first 5; rational: all 8).
  RadialTangential,
  /// Fisheye (Kannala and Brandt): (a, b) has the direction of (x, y) and the length
  /// t (1 + k1 t^2 + k2 t^4 + k3 t^6 + k4 t^8), where t is the angle to the optical axis, rad.
  Equidistant,
  /// Unified omnidirectional (Mei): RadialTangential of (x, y) / (z + xi |(x, y, z)|).
  Omnidirectional,
};
inline constexpr std::array<std::string_view, 4> kLensModelNames = {
    "pinhole", "radial_tangential", "equidistant", "omnidirectional"};
constexpr std::span<const std::string_view> enumNames(LensModel) { return kLensModelNames; }

/// A camera with the distortion of its lens, before rectification.
struct RawCamera {
  static constexpr const char* kRecord = "raw_camera";
  LensModel model = LensModel::Pinhole;
  int width = 0;   ///< px
  int height = 0;  ///< px
  Pinhole pinhole;
  /// Coefficients in the order of LensModel; those that the model does not have are 0.
  Eigen::Matrix<double, 8, 1> distortion = Eigen::Matrix<double, 8, 1>::Zero();
  double xi = 0;  ///< Omnidirectional: mirror parameter
  /// Metres. The reference is any coordinate frame that the cameras of a rig share, such as that of
  /// a body or of the first camera.
  Eigen::Isometry3d T_reference_camera = Eigen::Isometry3d::Identity();
  /// Rotation to the rectified camera; used only if RawRig::has_rectified is true.
  Eigen::Matrix3d R_rectified_camera = Eigen::Matrix3d::Identity();

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(model, "", "how the lens maps rays to pixels");
    TOLMAN_FIELD(width, "px", "image width");
    TOLMAN_FIELD(height, "px", "image height");
    TOLMAN_FIELD(pinhole.fx, "px", "focal length, horizontal");
    TOLMAN_FIELD(pinhole.fy, "px", "focal length, vertical");
    TOLMAN_FIELD(pinhole.cx, "px", "principal point, horizontal");
    TOLMAN_FIELD(pinhole.cy, "px", "principal point, vertical");
    TOLMAN_FIELD(distortion, "", "coefficients of the model");
    TOLMAN_FIELD(xi, "", "mirror parameter of the omnidirectional model");
    TOLMAN_FIELD(T_reference_camera, "m", "pose in the coordinate frame that the cameras share");
    TOLMAN_FIELD(R_rectified_camera, "", "rotation to the rectified camera, where it is given");
  }
};

/// The cameras of a source whose images are not rectified: the left (or only) one, then the right.
struct RawRig {
  static constexpr const char* kRecord = "raw_rig";
  std::vector<RawCamera> cameras;  ///< none: the images are rectified already
  bool has_rectified = false;      ///< `rectified` and R_rectified_camera are prescribed
  CameraRig rectified;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(cameras, "", "left (or only) camera, right camera");
    TOLMAN_FIELD(has_rectified, "", "whether the calibration prescribes the rectified cameras");
    TOLMAN_FIELD(rectified, "", "the rectified cameras, where they are prescribed");
  }
};

}  // namespace tolman
