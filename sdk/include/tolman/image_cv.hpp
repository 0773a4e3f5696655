// SPDX-License-Identifier: BSD-3-Clause
// Optional: images as cv::Mat, without copying pixels. This is the only SDK header that includes
// OpenCV; a plugin that uses it is declared by tolman_add_plugin(... OPENCV).
#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <stdexcept>
#include <utility>

#include "tolman/image.hpp"

namespace tolman {

/// A view of `image` as a cv::Mat, valid while `image` or a copy of it exists: the Mat does not own
/// the pixels. Do not write to it: the pixels are shared, and OpenCV has no read-only Mat.
inline cv::Mat asMat(const Image& image) {
  if (image.empty()) return {};
  const int type = image.format() == PixelFormat::Gray8 ? CV_8UC1 : CV_8UC3;
  return {image.height(), image.width(), type, const_cast<std::uint8_t*>(image.data()),
          static_cast<std::size_t>(image.stride())};
}

/// Wraps `mat` (CV_8UC1 or CV_8UC3) without copying; the image keeps the Mat's buffer alive.
/// The caller must not write to the buffer afterwards. Any other type throws.
inline Image asImage(const cv::Mat& mat) {
  if (mat.empty()) return {};
  if (mat.type() != CV_8UC1 && mat.type() != CV_8UC3) {
    throw std::invalid_argument("asImage takes CV_8UC1 or CV_8UC3");
  }
  auto owner = std::make_shared<const cv::Mat>(mat);
  const auto format = mat.type() == CV_8UC1 ? PixelFormat::Gray8 : PixelFormat::Bgr8;
  const std::uint8_t* const data = owner->data;
  return {data,   mat.cols,        mat.rows, static_cast<std::ptrdiff_t>(mat.step[0]),
          format, std::move(owner)};
}

}  // namespace tolman
