// SPDX-License-Identifier: BSD-3-Clause
#include "host/frame_images.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tolman::host {

namespace {

Status checkImage(const Image& image, const CameraRig& rig, const char* side) {
  const int width = image.width();
  const int height = image.height();
  if (image.empty()) {
    if (width == 0 && height == 0) return Status::ok();
    return Status::failed(
        fmt::format("the {} image has {}x{} px and no data", side, width, height));
  }
  if (width != rig.width || height != rig.height) {
    return Status::invalidInput(fmt::format("an image of {}x{} px; the rig has {}x{}", width,
                                            height, rig.width, rig.height));
  }
  if (image.format() != PixelFormat::Gray8 && image.format() != PixelFormat::Bgr8) {
    return Status::failed(fmt::format("the {} image has an unknown pixel format", side));
  }
  const std::ptrdiff_t row = std::ptrdiff_t{width} * bytesPerPixel(image.format());
  if (image.stride() >= row) return Status::ok();
  return Status::failed(fmt::format("the {} image has rows of {} bytes and a stride of {}", side,
                                    row, image.stride()));
}

}  // namespace

Status checkImages(const Frame& frame, const CameraRig& rig) {
  Status status = checkImage(frame.left, rig, "left");
  if (status.isOk()) status = checkImage(frame.right, rig, "right");
  if (!status.isOk() || !rig.isStereo()) return status;
  if (frame.left.empty() != frame.right.empty()) {
    return Status::failed(
        fmt::format("only the {} image of a pair; give both, or none and a 'defect' that says why",
                    frame.left.empty() ? "right" : "left"));
  }
  if (frame.left.empty() || frame.left.format() == frame.right.format()) return status;
  return Status::failed("the images of a pair have different pixel formats");
}

namespace {

// The limits are far beyond any camera, and beyond what parameters of sources allow: a source that
// accepts its parameters must not fail here. Chosen, not tuned.
constexpr double kMostFocal = 1e8;    // px
constexpr double kMostBeside = 1000;  // of the larger side of the image

Status checkFocal(const CameraRig& rig) {
  const auto [fx, fy, cx, cy] = rig.pinhole;
  if (fx > 0 && fy > 0 && std::max(fx, fy) <= kMostFocal) return Status::ok();
  return Status::invalidInput(
      fmt::format("the focal lengths of the cameras are {:.5g} and {:.5g} px; they must be above 0 "
                  "and at most {:g} px; correct the calibration, or set `calibrated` to false "
                  "where they are not known",
                  fx, fy, kMostFocal));
}

/// How far `centre` is outside of the pixels 0 to `size` - 1.
double outside(double centre, int size) { return std::max(-centre, centre - (size - 1)); }

Status checkCentre(const CameraRig& rig) {
  const auto [fx, fy, cx, cy] = rig.pinhole;
  const double most = kMostBeside * std::max(rig.width, rig.height);
  if (most == 0) return Status::ok();
  if (std::max(outside(cx, rig.width), outside(cy, rig.height)) <= most) return Status::ok();
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
