// SPDX-License-Identifier: BSD-3-Clause
// Conversion to grey and repeated halving.
#include "pyramid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "wide_lanes.hpp"

namespace tolman::direct_sparse {

namespace {

/// Weights of ITU-R BT.601 in 1/256.
void grayFromBgr(const std::uint8_t* bgr, std::uint8_t* gray, int width) {
  for (int u = 0; u < width; ++u, bgr += 3) {
    gray[u] = static_cast<std::uint8_t>((29 * bgr[0] + 150 * bgr[1] + 77 * bgr[2] + 128) >> 8);
  }
}

/// The pixel of a coarser level at column u. Rounds halves up in one column and down in the next,
/// so that levels do not get brighter.
template <class Value>
TOLMAN_INLINE Value quarter(Value sum, Value odd_column) {
  return (sum + 1 + odd_column) >> 2;
}

/// Sixteen columns of a row from two rows of the finer level.
TOLMAN_INLINE void halveSixteen(const std::uint8_t* p, const std::uint8_t* q, std::uint8_t* out) {
  using Bytes = std::uint8_t __attribute__((vector_size(16)));
  using Shorts = std::uint16_t __attribute__((vector_size(32)));  // pairs of bytes
  constexpr Shorts kOdd = {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};
  Shorts upper;
  Shorts lower;
  std::memcpy(&upper, p, sizeof upper);
  std::memcpy(&lower, q, sizeof lower);
  const Shorts sum = (upper & 255) + (upper >> 8) + (lower & 255) + (lower >> 8);
  const Bytes bytes = __builtin_convertvector(quarter(sum, kOdd), Bytes);
  std::memcpy(out, &bytes, sizeof bytes);
}

TOLMAN_WIDE_LANES void halve(const GrayLevel& fine, GrayLevel& coarse) {
  for (int v = 0; v < coarse.height; ++v) {
    const std::uint8_t* p = fine.row(2 * v);
    const std::uint8_t* q = fine.row(2 * v + 1);
    std::uint8_t* out = coarse.row(v);
    int u = 0;
    for (; u + 16 <= coarse.width; u += 16) halveSixteen(p + 2 * u, q + 2 * u, out + u);
    for (; u < coarse.width; ++u) {
      const int sum = p[2 * u] + p[2 * u + 1] + q[2 * u] + q[2 * u + 1];
      out[u] = static_cast<std::uint8_t>(quarter(sum, u & 1));
    }
  }
}

}  // namespace

void GrayLevel::resize(int new_width, int new_height) {
  if (width == new_width && height == new_height) return;
  width = new_width;
  height = new_height;
  const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  pixels.assign(size + kPadding, 0);
}

void ImagePyramid::build(const Image& image, int most, Noise noise) {
  constexpr int kSmallestSide = 16;  // px; chosen, not tuned
  GrayLevel& base = images_[0];
  base.resize(image.width(), image.height());
  for (int v = 0; v < base.height; ++v) {
    if (image.format() == PixelFormat::Bgr8) {
      grayFromBgr(image.row(v), base.row(v), base.width);
    } else {
      std::memcpy(base.row(v), image.row(v), static_cast<std::size_t>(base.width));
    }
  }
  if (noise == Noise::Smooth) smooth(base, smoothedShare(imageNoise(base)), buffer_);
  levels_ = 1;
  while (levels_ < most) {
    const GrayLevel& fine = images_[levels_ - 1];
    if (std::min(fine.width, fine.height) < 2 * kSmallestSide) break;
    images_[levels_].resize(fine.width / 2, fine.height / 2);
    halve(fine, images_[levels_]);
    ++levels_;
  }
}

GrayStatistics grayStatistics(const GrayLevel& image) {
  constexpr int kStep = 4;  // px; bounds the time
  double sum = 0;
  double squares = 0;
  double count = 0;
  for (int v = 0; v < image.height; v += kStep) {
    const std::uint8_t* row = image.row(v);
    int row_sum = 0;
    int row_squares = 0;
    for (int u = 0; u < image.width; u += kStep) {
      row_sum += row[u];
      row_squares += row[u] * row[u];
    }
    sum += row_sum;
    squares += row_squares;
    const int samples = (image.width + kStep - 1) / kStep;
    count += samples;
  }
  if (!(count > 0)) return {};
  const double mean = sum / count;
  return {static_cast<float>(mean),
          static_cast<float>(std::sqrt(std::max(0.0, squares / count - mean * mean)))};
}

// Quartile of second differences, and a binomial filter in whole numbers.

namespace {

// Lower quartile of the size of a normally distributed number of standard deviation 1.
constexpr double kNormalQuartile = 0.3186;
// Root of the sum of the squared weights 1 -2 1, -2 4 -2, 1 -2 1 of a difference.
constexpr double kDifferenceGain = 6;
constexpr std::size_t kSizes = 512;  // larger differences are not noise

using Histogram = std::array<int, kSizes>;

/// Sizes of the second differences on a grid, without black and saturated pixels, which hide noise.
Histogram differenceHistogram(const GrayLevel& image) {
  constexpr int kStep = 3;  // px; differences do not overlap
  Histogram sizes{};
  for (int v = 1; v + 1 < image.height; v += kStep) {
    const std::uint8_t* a = image.row(v - 1);
    const std::uint8_t* b = image.row(v);
    const std::uint8_t* c = image.row(v + 1);
    for (int u = 1; u + 1 < image.width; u += kStep) {
      if (b[u] == 0 || b[u] == 255) continue;
      const int corners = a[u - 1] + a[u + 1] + c[u - 1] + c[u + 1];
      const int sides = a[u] + c[u] + b[u - 1] + b[u + 1];
      const auto size = static_cast<std::size_t>(std::abs(corners - 2 * sides + 4 * b[u]));
      ++sizes[std::min(size, kSizes - 1)];
    }
  }
  return sizes;
}

}  // namespace

float imageNoise(const GrayLevel& image) {
  const Histogram sizes = differenceHistogram(image);
  int count = 0;
  for (const int n : sizes) count += n;
  double missing = 0.25 * count;
  for (std::size_t size = 0; size < sizes.size(); ++size) {
    if (missing < sizes[size]) {
      // Differences were rounded: those of one size are spread over half a level to both sides.
      const double within = missing / sizes[size];
      const double quartile = size == 0 ? 0.5 * within : static_cast<double>(size) - 0.5 + within;
      return static_cast<float>(quartile / (kNormalQuartile * kDifferenceGain));
    }
    missing -= sizes[size];
  }
  return 0;
}

float smoothedShare(float noise) {
  // Grey levels. Images of KITTI and of the town by day have 1.2 to 2.3 and are not changed,
  // because smoothing costs accuracy there; by night the town has 4 to 5. Chosen on the town along
  // KITTI 06.
  constexpr float kQuiet = 2.5F;
  constexpr float kNoisy = 4;
  return std::clamp((noise - kQuiet) / (kNoisy - kQuiet), 0.0F, 1.0F);
}

void smooth(GrayLevel& image, float share, std::vector<std::uint8_t>& before) {
  const int weight = static_cast<int>(256 * share);
  if (weight == 0 || image.width == 0) return;
  before = image.pixels;
  const auto row = [&](int v) {
    const auto inside = static_cast<std::ptrdiff_t>(std::clamp(v, 0, image.height - 1));
    return before.data() + inside * image.width;
  };
  const int last = image.width - 1;
  for (int v = 0; v < image.height; ++v) {
    const std::uint8_t* a = row(v - 1);
    const std::uint8_t* b = row(v);
    const std::uint8_t* c = row(v + 1);
    std::uint8_t* out = image.row(v);
    const auto mix = [&](int left, int u, int right) {
      const int corners = a[left] + a[right] + c[left] + c[right];
      const int sides = a[u] + c[u] + b[left] + b[right];
      const int mean = corners + 2 * sides + 4 * b[u];  // sixteenfold
      const int mixed = weight * mean + 16 * (256 - weight) * b[u];
      out[u] = static_cast<std::uint8_t>((mixed + 2048) >> 12);
    };
    mix(0, 0, std::min(1, last));
    for (int u = 1; u < last; ++u) mix(u - 1, u, u + 1);
    if (last > 0) mix(last - 1, last, last);
  }
}

}  // namespace tolman::direct_sparse
