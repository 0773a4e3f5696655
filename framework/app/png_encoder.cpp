// SPDX-License-Identifier: BSD-3-Clause
// Images and depth maps as PNG bytes, fast rather than small.
#include <png.h>

#include <cmath>
#include <vector>

#include "app/kitti_folder.hpp"

namespace tolman::app {
namespace {

/// `stride`: components from row to row.
Result<std::string> encode(png_uint_32 format, int width, int height, const void* pixels,
                           int stride) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = format;
  image.flags = PNG_IMAGE_FLAG_FAST;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels, stride, nullptr) == 0) {
    return Status::failed(std::string("the image cannot be encoded as PNG: ") + image.message);
  }
  bytes.resize(size);
  return bytes;
}

std::uint16_t depthPixel(float metres) {
  const double steps = std::round(256.0 * static_cast<double>(metres));
  return steps >= 1 && steps <= 65535 ? static_cast<std::uint16_t>(steps) : std::uint16_t{0};
}

}  // namespace

Result<std::string> encodePng(const Image& image) {
  const bool is_grey = image.format() == PixelFormat::Gray8;
  return encode(is_grey ? PNG_FORMAT_GRAY : PNG_FORMAT_BGR, image.width(), image.height(),
                image.data(), static_cast<int>(image.stride()));
}

Result<std::string> encodeDepthPng(const NamedArray& depth) {
  const bool plane = depth.shape.size() == 2 && depth.shape[0] > 0 && depth.shape[1] > 0;
  if (!plane || depth.values.size() != static_cast<std::size_t>(depth.shape[0]) *
                                           static_cast<std::size_t>(depth.shape[1])) {
    return Status::invalidInput("'" + depth.name + "' has not the shape {height, width}");
  }
  std::vector<std::uint16_t> pixels;
  pixels.reserve(depth.values.size());
  for (const float metres : depth.values) pixels.push_back(depthPixel(metres));
  return encode(PNG_FORMAT_LINEAR_Y, depth.shape[1], depth.shape[0], pixels.data(), depth.shape[1]);
}

}  // namespace tolman::app
