// SPDX-License-Identifier: BSD-3-Clause
// The calibration of rectified images as parameters of a source: pinhole and baseline.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/parameters.hpp"
#include "tolman/status.hpp"

namespace tolman::source_parameters {

/// Base of a source's Parameters.
struct GivenPinhole {
  /// px: [fx, fy, cx, cy], or [f] about the middle of the image; of raw images (isRaw())
  /// coefficients follow.
  std::vector<double> pinhole;
  double baseline = 0;  ///< m

  bool isGiven() const { return !pinhole.empty(); }
  bool isRaw() const { return pinhole.size() > 4; }
  /// The rig of images of this size; uncalibrated unless a pinhole is given. InvalidParameter
  /// for a principal point outside of the image.
  Result<CameraRig> rig(int width, int height) const {
    CameraRig rig;
    rig.width = width;
    rig.height = height;
    if (!isGiven()) return rig;
    rig.calibrated = true;
    rig.baseline = baseline;
    if ((pinhole.size() != 1 && pinhole.size() != 4) || pinhole[0] <= 0) {
      return Status::invalidParameter(
          "pinhole is not [fx, fy, cx, cy], or [f] about the middle of the image; give these "
          "numbers "
          "in px");
    }
    const bool whole = pinhole.size() == 4;
    rig.pinhole = {pinhole[0], whole ? pinhole[1] : pinhole[0],
                   whole ? pinhole[2] : (width - 1) / 2.0, whole ? pinhole[3] : (height - 1) / 2.0};
    if (rig.pinhole.fy > 0 && rig.pinhole.cx >= 0 && rig.pinhole.cy >= 0 &&
        rig.pinhole.cx < width && rig.pinhole.cy < height)
      return rig;
    return Status::invalidParameter("the principal point of pinhole is outside of the image of " +
                                    std::to_string(width) + "x" + std::to_string(height) +
                                    " px; give the calibration of this camera");
  }
};

/// Declarations for a Parameters struct that derives from GivenPinhole. `least`: of its numbers.
template <std::derived_from<GivenPinhole> P>
constexpr auto pinholeParameter(
    std::string_view doc =
        "[fx, fy, cx, cy] of rectified images, or [f] about the middle of the "
        "image; empty for an uncalibrated camera.",
    double least = 0) {
  return parameters(parameter<P, std::vector<double>>("pinhole", &P::pinhole)
                        .range(least, 1e6)
                        .unit("px")
                        .doc(doc));
}

template <std::derived_from<GivenPinhole> P>
constexpr auto baselineParameter() {
  return parameters(parameter<P, double>("baseline", &P::baseline)
                        .range(0, 5)
                        .unit("m")
                        .doc("Distance of the right camera from the left one, with pinhole."));
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

/// The camera of raw images of this size, of a pinhole with coefficients in OpenCV's order.
inline Result<RawCamera> rawCamera(const GivenPinhole& given, int width, int height) {
  const std::span<const double> all(given.pinhole);
  GivenPinhole straight = given;
  straight.pinhole.resize(4);
  const Result<CameraRig> rig = straight.rig(width, height);
  if (!rig.isOk()) return rig.status();
  RawCamera camera;
  camera.width = width;
  camera.height = height;
  camera.pinhole = rig.value().pinhole;
  const Status status = setLens("radtan", all.subspan(4), camera);
  if (!status.isOk()) return Status::invalidParameter("pinhole " + status.message());
  return camera;
}

}  // namespace tolman::source_parameters
