// SPDX-License-Identifier: BSD-3-Clause
#include "imaging/pixel_map.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "imaging/lens.hpp"

namespace tolman::imaging {
namespace {

constexpr int kParts = 128;      // of a pixel
constexpr int kRowsAtOnce = 32;  // of a task

template <class Work>
void forRows(int rows, const Work& work) {
  tbb::parallel_for(tbb::blocked_range<int>(0, rows, kRowsAtOnce),
                    [&](const tbb::blocked_range<int>& range) {
                      for (int r = range.begin(); r < range.end(); ++r) work(r);
                    });
}

}  // namespace

PixelMap::PixelMap(const RawCamera& raw, const Eigen::Matrix3d& R_rectified_raw,
                   const CameraRig& rectified)
    : raw_width_(raw.width),
      raw_height_(raw.height),
      width_(rectified.width),
      height_(rectified.height),
      places_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {
  const Lens lens(raw);
  const Eigen::Matrix3d R_raw_rectified = R_rectified_raw.transpose();
  forRows(height_, [&](int r) {
    Place* place = places_.data() + std::ptrdiff_t{r} * width_;
    for (int c = 0; c < width_; ++c, ++place) {
      const auto pixel = lens.pixelOf(R_raw_rectified * rectified.pinhole.ray({c, r}));
      if (!pixel) continue;
      const auto split = [](double at, int size, std::uint8_t& share) {
        const int parts = static_cast<int>(std::lround(at * kParts));
        const int whole = std::min(parts / kParts, size - 2);
        share = static_cast<std::uint8_t>(parts - whole * kParts);
        return static_cast<std::uint16_t>(whole);
      };
      place->x = split(pixel->x(), raw_width_, place->right);
      place->y = split(pixel->y(), raw_height_, place->below);
    }
  });
  black_ = std::ranges::count(places_, kNowhere, &Place::right);
}

template <int Channels>
void PixelMap::fillRow(const Image& raw, int row, std::uint8_t* out) const {
  const Place* place = places_.data() + std::ptrdiff_t{row} * width_;
  const std::uint8_t* const data = raw.data();
  const std::ptrdiff_t stride = raw.stride();
  for (const Place* const end = place + width_; place != end; ++place, out += Channels) {
    if (place->right == kNowhere) continue;
    const std::uint8_t* above = data + place->y * stride + place->x * Channels;
    const std::uint8_t* below = above + stride;
    const int w_right = place->right;
    const int w_left = kParts - w_right;
    for (int k = 0; k < Channels; ++k) {
      const int upper = above[k] * w_left + above[k + Channels] * w_right;
      const int lower = below[k] * w_left + below[k + Channels] * w_right;
      const int sum = upper * (kParts - place->below) + lower * place->below;
      out[k] = static_cast<std::uint8_t>((sum + kParts * kParts / 2) / (kParts * kParts));
    }
  }
}

Image PixelMap::apply(const Image& raw) const {
  if (raw.width() != raw_width_ || raw.height() != raw_height_) return {};
  return Image::create(width_, height_, raw.format(), [&](std::uint8_t* pixels) {
    const std::ptrdiff_t stride = std::ptrdiff_t{width_} * bytesPerPixel(raw.format());
    forRows(height_, [&](int r) {
      if (raw.format() == PixelFormat::Gray8) {
        fillRow<1>(raw, r, pixels + r * stride);
      } else {
        fillRow<3>(raw, r, pixels + r * stride);
      }
    });
  });
}

}  // namespace tolman::imaging
