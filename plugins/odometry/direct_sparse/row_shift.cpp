// SPDX-License-Identifier: BSD-3-Clause
#include "row_shift.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "wide_lanes.hpp"

namespace tolman::direct_sparse {
namespace {

constexpr int kSteps = 32;    // of a pixel
constexpr int kColumns = 16;  // px, width of a block
constexpr int kRows = 8;      // px, height of a block
constexpr int kScale = 64;    // sum of the weights
// Weights are at most 64, and negative ones at least -5, so that sums fit into 16 bits.
static_assert(kSteps == 1 << 5 && kScale == 1 << 6 && kColumns <= int{GrayLevel::kPadding});
constexpr int kMost = 8;  // px, largest displacement; fields are far below it

using Weights = std::array<std::int16_t, 4>;

constexpr int rounded(double value) { return static_cast<int>(value + (value < 0 ? -0.5 : 0.5)); }

/// Catmull-Rom between the second and the third of four rows, at f / kSteps below the second.
constexpr Weights weightsOf(int f) {
  const double t = static_cast<double>(f) / kSteps;
  const int first = rounded(kScale * 0.5 * t * (-1 + t * (2 - t)));
  const int third = rounded(kScale * 0.5 * t * (1 + t * (4 - 3 * t)));
  const int fourth = rounded(kScale * 0.5 * t * t * (t - 1));
  const int second = kScale - first - third - fourth;
  return {static_cast<std::int16_t>(first), static_cast<std::int16_t>(second),
          static_cast<std::int16_t>(third), static_cast<std::int16_t>(fourth)};
}

constexpr std::array<Weights, kSteps> allWeights() {
  std::array<Weights, kSteps> weights{};
  for (int f = 0; f < kSteps; ++f) weights[static_cast<std::size_t>(f)] = weightsOf(f);
  return weights;
}

using Bytes = std::uint8_t __attribute__((vector_size(kColumns)));
using Shorts = std::int16_t __attribute__((vector_size(2 * kColumns)));

TOLMAN_INLINE Shorts loadShorts(const std::uint8_t* p) {
  Bytes bytes;
  std::memcpy(&bytes, p, sizeof bytes);
  return __builtin_convertvector(bytes, Shorts);
}

/// Pixels of the rows from v on, in column u; the outermost row for rows outside of the image.
TOLMAN_INLINE std::array<const std::uint8_t*, 4> fourRows(const GrayLevel& image, int u, int v) {
  if (v >= 0 && v + 3 < image.height) {
    const std::uint8_t* p = image.row(v) + u;
    const std::ptrdiff_t width = image.width;
    return {p, p + width, p + 2 * width, p + 3 * width};
  }
  const auto row = [&](int at) { return image.row(std::clamp(at, 0, image.height - 1)) + u; };
  return {row(v), row(v + 1), row(v + 2), row(v + 3)};
}

/// One row of the result, displaced by `steps` (one a block). Writes whole blocks, up to
/// GrayLevel::kPadding bytes too many.
TOLMAN_WIDE_LANES void mixRows(const GrayLevel& image, const std::int16_t* steps, int v,
                               std::uint8_t* out) {
  constexpr std::array<Weights, kSteps> kWeights = allWeights();
  for (int u = 0; u < image.width; u += kColumns, ++steps, out += kColumns) {
    const int whole = *steps >> 5;  // rounded down
    const Weights& w = kWeights[static_cast<std::size_t>(*steps & (kSteps - 1))];
    const auto [a, b, c, d] = fourRows(image, u, v + whole - 1);
    const Shorts sum =
        w[0] * loadShorts(a) + w[1] * loadShorts(b) + w[2] * loadShorts(c) + w[3] * loadShorts(d);
    const Shorts mixed = (sum + kScale / 2) >> 6;
    constexpr Shorts kBlack{};
    constexpr Shorts kWhite = kBlack + 255;
    const Shorts bounded = mixed < kBlack ? kBlack : mixed > kWhite ? kWhite : mixed;
    const Bytes bytes = __builtin_convertvector(bounded, Bytes);
    std::memcpy(out, &bytes, sizeof bytes);
  }
}

}  // namespace

void RowShift::set(const SmoothField& field, int width, int height) {
  width_ = width;
  height_ = height;
  across_ = (width + kColumns - 1) / kColumns;
  const int blocks = across_ * ((height + kRows - 1) / kRows);
  steps_.resize(static_cast<std::size_t>(blocks));
  for (int i = 0; i < blocks; ++i) {
    const int column = i % across_;
    const int row = i / across_;
    const double u = (column + 0.5) * kColumns - 0.5;
    const double v = (row + 0.5) * kRows - 0.5;
    const double shift = std::clamp(field.at(u, v, width, height), -1.0 * kMost, 1.0 * kMost);
    steps_[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(std::lround(kSteps * shift));
  }
}

double RowShift::at(double u, double v) const {
  if (steps_.empty()) return 0;
  const int x = std::clamp(static_cast<int>(u + 0.5), 0, width_ - 1) / kColumns;
  const int y = std::clamp(static_cast<int>(v + 0.5), 0, height_ - 1) / kRows;
  return static_cast<double>(steps_[static_cast<std::size_t>(y * across_ + x)]) / kSteps;
}

void RowShift::apply(GrayLevel& image) {
  if (steps_.empty()) return;
  buffer_.resize(image.pixels.size());
  for (int v = 0; v < height_; ++v) {
    mixRows(image, steps_.data() + static_cast<std::ptrdiff_t>(v / kRows) * across_, v,
            buffer_.data() + static_cast<std::ptrdiff_t>(v) * width_);
  }
  std::fill(buffer_.begin() + static_cast<std::ptrdiff_t>(width_) * height_, buffer_.end(), 0);
  std::swap(image.pixels, buffer_);
}

}  // namespace tolman::direct_sparse
