// SPDX-License-Identifier: BSD-3-Clause
#include "host/frame_images.hpp"

#include <fmt/format.h>

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

}  // namespace tolman::host
