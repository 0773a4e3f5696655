// SPDX-License-Identifier: BSD-3-Clause
// An image as it crosses the plugin boundary: a small, owning, read-only view.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>

namespace tolman {

enum class PixelFormat : std::uint8_t {
  Gray8,  ///< one byte a pixel
  Bgr8,   ///< three bytes a pixel, blue first, as in OpenCV
};

constexpr int bytesPerPixel(PixelFormat format) { return format == PixelFormat::Gray8 ? 1 : 3; }

/// Immutable pixels, shared by all copies of this view.
///
/// - Row r starts at data() + r * stride(); stride() is in bytes, at least width * bytesPerPixel.
/// - Copying copies the view, not the pixels; the pixels are freed with the last view of them.
/// - Published pixels are immutable, so any number of threads may read them.
/// - The centre of the top left pixel has the coordinates (0, 0).
/// - An empty image (no camera, corrupt file) has width 0 and a null pointer.
class Image {
 public:
  Image() = default;

  /// A view of memory that `owner` keeps valid; `owner` is released with the last view.
  Image(const std::uint8_t* data, int width, int height, std::ptrdiff_t stride, PixelFormat format,
        std::shared_ptr<const void> owner)
      : owner_(std::move(owner)),
        data_(data),
        stride_(stride),
        width_(width),
        height_(height),
        format_(format) {}

  /// Allocates tightly packed zeroed pixels and lets `fill(std::uint8_t* data)` write them.
  template <class Fill>
  static Image create(int width, int height, PixelFormat format, Fill&& fill) {
    const std::ptrdiff_t stride = std::ptrdiff_t{width} * bytesPerPixel(format);
    const auto size = static_cast<std::size_t>(stride * height);
    const std::shared_ptr<std::uint8_t[]> pixels(new std::uint8_t[size]());
    std::forward<Fill>(fill)(pixels.get());
    return {pixels.get(), width, height, stride, format, pixels};
  }

  bool empty() const { return data_ == nullptr; }
  int width() const { return width_; }
  int height() const { return height_; }
  std::ptrdiff_t stride() const { return stride_; }
  PixelFormat format() const { return format_; }
  const std::uint8_t* data() const { return data_; }
  const std::uint8_t* row(int r) const { return data_ + r * stride_; }
  const std::shared_ptr<const void>& owner() const { return owner_; }

 private:
  std::shared_ptr<const void> owner_;
  const std::uint8_t* data_ = nullptr;
  std::ptrdiff_t stride_ = 0;
  int width_ = 0;
  int height_ = 0;
  PixelFormat format_ = PixelFormat::Gray8;
};

}  // namespace tolman
