// SPDX-License-Identifier: BSD-3-Clause
#include "engine/pixel_map.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "engine/lens.hpp"

namespace tolman::engine {
namespace {

constexpr int kRowsAtOnce = 32;  // rows per task

template <class Work>
void forRows(int rows, const Work& work) {
  tbb::parallel_for(tbb::blocked_range<int>(0, rows, kRowsAtOnce),
                    [&](const tbb::blocked_range<int>& range) {
                      for (int r = range.begin(); r < range.end(); ++r) work(r);
                    });
}

/// The pixel before a position; `share` is the rest in 1/kParts px.
std::uint16_t split(double at, int size, std::uint8_t& share) {
  const int parts = static_cast<int>(std::lround(at * kParts));
  const int whole = std::min(parts / kParts, size - 2);
  share = static_cast<std::uint8_t>(parts - whole * kParts);
  return static_cast<std::uint16_t>(whole);
}

}  // namespace

PixelMap::PixelMap(const RawCamera& raw, const Eigen::Matrix3d& R_rectified_raw,
                   const CameraRig& rectified, Speed speed)
    : raw_width_(raw.width),
      raw_height_(raw.height),
      width_(rectified.width),
      height_(rectified.height),
      positions_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {
  const bool grouped = speed == Speed::Fastest && hasGroupInstructions();
  if (grouped) groups_.resize(firstGroup(height_));
  const Lens lens(raw);
  const Eigen::Matrix3d R_raw_rectified = R_rectified_raw.transpose();
  forRows(height_, [&](int r) {
    RawPosition* position = positions_.data() + std::ptrdiff_t{r} * width_;
    for (int c = 0; c < width_; ++c, ++position) {
      const auto pixel = lens.pixelOf(R_raw_rectified * rectified.pinhole.ray({c, r}));
      if (!pixel) continue;
      position->x = split(pixel->x(), raw_width_, position->right);
      position->y = split(pixel->y(), raw_height_, position->below);
    }
    if (grouped) groupPositions(positionsOf(r), raw_width_, groups_.data() + firstGroup(r));
  });
}

std::span<const RawPosition> PixelMap::positionsOf(int row) const {
  const auto width = static_cast<std::size_t>(width_);
  return std::span(positions_).subspan(static_cast<std::size_t>(row) * width, width);
}

Image PixelMap::apply(const Image& raw) const {
  if (raw.width() != raw_width_ || raw.height() != raw_height_) return {};
  return Image::create(width_, height_, raw.format(), [&](std::uint8_t* pixels) {
    const std::ptrdiff_t stride = std::ptrdiff_t{width_} * bytesPerPixel(raw.format());
    forRows(height_, [&](int r) {
      const PixelGroup* groups = groups_.empty() ? nullptr : groups_.data() + firstGroup(r);
      interpolateRow(raw, positionsOf(r), groups, pixels + r * stride);
    });
  });
}

}  // namespace tolman::engine
