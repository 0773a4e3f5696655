// SPDX-License-Identifier: BSD-3-Clause
#include "picture_layout.hpp"

#include <string>

namespace tolman::video {
namespace {

PictureSize halved(PictureSize size, PictureLayout layout) {
  if (layout == PictureLayout::SideBySide) size.width /= 2;
  if (layout == PictureLayout::TopBottom) size.height /= 2;
  return size;
}

/// The part of `picture` of this size that begins at column x and row y.
Image part(const Image& picture, int x, int y, PictureSize size) {
  const std::ptrdiff_t column = std::ptrdiff_t{x} * bytesPerPixel(picture.format());
  return {picture.row(y) + column, size.width,       size.height,
          picture.stride(),        picture.format(), picture.owner()};
}

}  // namespace

Result<PictureSize> cameraSize(PictureSize picture, PictureLayout layout) {
  const PictureSize size = halved(picture, layout);
  const bool whole = (layout != PictureLayout::SideBySide || size.width * 2 == picture.width) &&
                     (layout != PictureLayout::TopBottom || size.height * 2 == picture.height);
  if (whole && size.width > 0 && size.height > 0) return size;
  return Status::invalidParameter(
      "pictures of " + std::to_string(picture.width) + "x" + std::to_string(picture.height) +
      " px are not two equal halves " +
      (layout == PictureLayout::SideBySide ? "side by side" : "one above the other") +
      "; correct layout");
}

Image leftImage(const Image& picture, PictureLayout layout) {
  if (picture.empty() || layout == PictureLayout::Mono) return picture;
  return part(picture, 0, 0, halved({picture.width(), picture.height()}, layout));
}

Image rightImage(const Image& picture, PictureLayout layout) {
  if (picture.empty() || layout == PictureLayout::Mono) return {};
  const PictureSize size = halved({picture.width(), picture.height()}, layout);
  const bool beside = layout == PictureLayout::SideBySide;
  return part(picture, beside ? size.width : 0, beside ? 0 : size.height, size);
}

}  // namespace tolman::video
