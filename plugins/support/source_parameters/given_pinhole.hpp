// SPDX-License-Identifier: BSD-3-Clause
// The calibration of rectified images as parameters of a source: fx, fy, cx, cy and baseline.
#pragma once

#include <concepts>
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

}  // namespace tolman::source_parameters
