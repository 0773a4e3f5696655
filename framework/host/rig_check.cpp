// SPDX-License-Identifier: BSD-3-Clause
#include "host/rig_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tolman::host {
namespace {

/// The narrowest image has 0.06 degrees, less than the longest telephoto lenses. Chosen, not tuned.
constexpr double kMostFocal = 1000;  // of the larger side of the image

Status checkFocal(const CameraRig& rig) {
  const auto [fx, fy, cx, cy] = rig.pinhole;
  const double most = kMostFocal * std::max(rig.width, rig.height);
  const auto is_possible = [&](double f) { return f > 0 && (rig.width == 0 || f <= most); };
  if (is_possible(fx) && is_possible(fy)) return Status::ok();
  return Status::invalidInput(
      fmt::format("the focal lengths of the cameras are {:.5g} and {:.5g} px; they must be above 0 "
                  "and at most {:g} times the images' larger side; correct the calibration, or set "
                  "`calibrated` to false where they are not known",
                  fx, fy, kMostFocal));
}

/// How far `centre` is outside of the pixels 0 to `size` - 1.
double outside(double centre, int size) { return std::max(-centre, centre - (size - 1)); }

/// A part of an image may lie beside its principal point, but hardly by more than its own size and
/// 70 degrees, which few rectified images reach at all. Chosen, not tuned.
constexpr double kMostBeside = 2.75;  // tangent of 70 degrees

Status checkCentre(const CameraRig& rig) {
  const auto [fx, fy, cx, cy] = rig.pinhole;
  const double side = std::max(rig.width, rig.height);
  if (side == 0) return Status::ok();
  const bool is_near = outside(cx, rig.width) <= std::max(side, kMostBeside * fx) &&
                       outside(cy, rig.height) <= std::max(side, kMostBeside * fy);
  if (is_near) return Status::ok();
  return Status::invalidInput(
      fmt::format("the principal point ({:.5g}, {:.5g}) px is far outside of the images of {}x{} "
                  "px; correct cx and cy in the calibration, or the size of the images",
                  cx, cy, rig.width, rig.height));
}

}  // namespace

Status checkRig(const CameraRig& rig) {
  if (rig.width < 0 || rig.height < 0 || (rig.width == 0) != (rig.height == 0)) {
    return Status::invalidInput(
        fmt::format("the cameras have images of {}x{} px; give their width and height, or 0 and 0 "
                    "where there are no images",
                    rig.width, rig.height));
  }
  if (rig.baseline < 0) {
    return Status::invalidInput(
        fmt::format("the baseline of the cameras is {:.5g} m; it is the distance of the right "
                    "camera to the right of the left one: exchange the two cameras if they are "
                    "the wrong way round, or give 0 for a single one",
                    rig.baseline));
  }
  if (!rig.calibrated) return Status::ok();
  const Status status = checkFocal(rig);
  return status.isOk() ? checkCentre(rig) : status;
}

}  // namespace tolman::host
