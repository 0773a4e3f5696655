// SPDX-License-Identifier: BSD-3-Clause
// The calibration of rectified images as parameters of a source: fx, fy, cx, cy and baseline.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <span>
#include <string>
#include <string_view>

#include "tolman/camera.hpp"
#include "tolman/parameters.hpp"
#include "tolman/status.hpp"

namespace tolman::source_parameters {

/// Base of a source's Parameters.
struct GivenPinhole {
  double fx = 0;        ///< px; 0: no calibration is given
  double fy = 0;        ///< px; 0: as fx
  double cx = 0;        ///< px; 0: the centre of the image
  double cy = 0;        ///< px; 0: the centre of the image
  double baseline = 0;  ///< m

  bool isGiven() const { return fx > 0; }
  /// For images of this size.
  Pinhole pinhole(int width, int height) const {
    return {fx, fy > 0 ? fy : fx, cx > 0 ? cx : (width - 1) / 2.0,
            cy > 0 ? cy : (height - 1) / 2.0};
  }
  /// The rig of images of this size; uncalibrated unless fx is given. InvalidParameter for a
  /// principal point outside of the image.
  Result<CameraRig> rig(int width, int height) const {
    CameraRig rig;
    rig.width = width;
    rig.height = height;
    if (!isGiven()) return rig;
    rig.calibrated = true;
    rig.pinhole = pinhole(width, height);
    rig.baseline = baseline;
    if (rig.pinhole.cx < width && rig.pinhole.cy < height) return rig;
    return Status::invalidParameter("the principal point cx, cy is outside of the image of " +
                                    std::to_string(width) + "x" + std::to_string(height) +
                                    " px; give the calibration of this camera");
  }
};

/// Declaration of these parameters but baseline for a Parameters struct that derives from
/// GivenPinhole.
template <std::derived_from<GivenPinhole> P>
constexpr auto pinholeParameters(
    std::string_view fx_doc = "Focal length; 0 for an uncalibrated camera.") {
  return parameters(parameter<P, double>("fx", &P::fx).range(0, 1e6).unit("px").doc(fx_doc),
                    parameter<P, double>("fy", &P::fy)
                        .range(0, 1e6)
                        .unit("px")
                        .doc("Vertical focal length; 0 for the same as fx."),
                    parameter<P, double>("cx", &P::cx)
                        .range(0, 1e6)
                        .unit("px")
                        .doc("Principal point, horizontal; 0 for the centre of the image."),
                    parameter<P, double>("cy", &P::cy)
                        .range(0, 1e6)
                        .unit("px")
                        .doc("Principal point, vertical; 0 for the centre of the image."));
}

template <std::derived_from<GivenPinhole> P>
constexpr auto baselineParameter() {
  return parameters(parameter<P, double>("baseline", &P::baseline)
                        .range(0, 5)
                        .unit("m")
                        .doc("Distance of the right camera from the left one, with fx."));
}

// The matrix P = K [I | t] of a rectified camera, as KITTI, ROS and OpenCV write it.

using Projection = Eigen::Matrix<double, 3, 4>;

inline Pinhole pinholeOf(const Projection& P) { return {P(0, 0), P(1, 1), P(0, 2), P(1, 2)}; }

/// t of P, m: the origin of the reference in the axes of the rectified camera.
inline Eigen::Vector3d offsetOf(const Projection& P) {
  const Pinhole K = pinholeOf(P);
  return {(P(0, 3) - K.cx * P(2, 3)) / K.fx, (P(1, 3) - K.cy * P(2, 3)) / K.fy, P(2, 3)};
}

/// Whether a right camera that is at `t` in the axes of the left one is beside it: images of others
/// are not rectified.
inline bool isBeside(const Eigen::Vector3d& t) {
  // Chosen, not tuned. KITTI's colour pairs have 0.005 (odometry) to 0.009 (raw).
  constexpr double kMisaligned = 0.02;  // of the baseline
  return std::hypot(t.y(), t.z()) <= kMisaligned * std::abs(t.x());
}

// The distortion of a lens by the name of its model and its coefficients, as calibration files,
// messages and drivers give them.

/// Sets model and distortion of `camera`. Coefficients that are all 0 are a lens without distortion
/// in every model but a fisheye's, and zeros beyond those that a model has are none: drivers fill
/// up to 8 or 14. The message of a failure completes the sentence "FILE ...".
inline Status setLens(std::string_view name, std::span<const double> coefficients,
                      RawCamera& camera) {
  const auto isOneOf = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const bool is_fisheye =
      isOneOf({"equidistant", "equi", "fisheye", "kannala_brandt", "kannala_brandt4"});
  const bool is_radial =
      isOneOf({"radtan", "radial-tangential", "plumb_bob", "rational_polynomial"});
  std::size_t count = coefficients.size();
  while (count > 0 && coefficients[count - 1] == 0) --count;
  camera.distortion.setZero();
  camera.model = LensModel::Pinhole;
  if (is_fisheye ? coefficients.empty() : count == 0) return Status::ok();
  if (!is_fisheye && !is_radial) {
    return Status::unsupported("has the distortion model '" + std::string(name.substr(0, 40)) +
                               "', which is not known; calibrate with radtan (plumb_bob), "
                               "rational_polynomial or equidistant");
  }
  const std::size_t given = coefficients.size();
  const bool fits = is_fisheye ? given >= 4 && count <= 4
                               : (given == 4 || given == 5 || given >= 8) && count <= 8;
  if (!fits) {
    return Status::unsupported("has " + std::to_string(given) + " coefficients of the model '" +
                               std::string(name) + "'; known are " +
                               (is_fisheye ? "4" : "4, 5 or 8"));
  }
  camera.model = is_fisheye ? LensModel::Equidistant : LensModel::RadialTangential;
  std::copy_n(coefficients.begin(), count, camera.distortion.data());
  return Status::ok();
}

}  // namespace tolman::source_parameters
