// SPDX-License-Identifier: BSD-3-Clause
// Patches in 16-bit integers, so that results are the same on every processor.
#include "patch_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "wide_lanes.hpp"

namespace tolman::feature_stereo {
namespace {

using Shorts = std::int16_t __attribute__((vector_size(2 * kLanes)));
using Bytes = std::uint8_t __attribute__((vector_size(kLanes)));

// Products that are added in 32 bits: 256 * (8 * 255)^2 < 2^31.
constexpr int kExact = 256;
// 7 bits: with a grey level of 8 bits they fill 15.
constexpr int kRightOne = 1 << 7;
constexpr int kBelowOne = 1 << 15;

/// From the centre of a patch to that of its outer pixels.
float radiusOf(int side) {
  const int radius = side / 2;
  return static_cast<float>(radius);
}

TOLMAN_INLINE Shorts loadWidened(const uchar* p) {
  Bytes bytes;
  std::memcpy(&bytes, p, sizeof bytes);
  return __builtin_convertvector(bytes, Shorts);
}

TOLMAN_INLINE Shorts loadShorts(const std::int16_t* p) {
  Shorts values;
  std::memcpy(&values, p, sizeof values);
  return values;
}
TOLMAN_INLINE void store(Shorts values, std::int16_t* p) { std::memcpy(p, &values, sizeof values); }

/// Between a pixel and the next one of its row, times kRightOne.
TOLMAN_INLINE Shorts betweenColumns(const uchar* p, std::int16_t right) {
  const Shorts here = loadWidened(p);
  return here * std::int16_t(kRightOne) + right * (loadWidened(p + 1) - here);
}

/// The upper half of a product.
TOLMAN_INLINE Shorts upperHalf(Shorts a, std::int16_t b) {
  std::int16_t lanes[kLanes];
  std::memcpy(lanes, &a, sizeof a);
  for (std::int16_t& lane : lanes) lane = static_cast<std::int16_t>((lane * b) >> 16);
  Shorts result;
  std::memcpy(&result, lanes, sizeof result);
  return result;
}

TOLMAN_WIDE_LANES
void interpolateLanes(const uchar* p, std::ptrdiff_t step, int rows, std::int16_t right,
                      std::int16_t below, std::int16_t* gray, std::ptrdiff_t gray_step) {
  Shorts above = betweenColumns(p, right);
  for (int y = 0; y < rows; ++y) {
    p += step;
    const Shorts next = betweenColumns(p, right);
    const Shorts half = (above >> 1) + upperHalf(next - above, below);
    const Shorts value = (half + std::int16_t(4)) >> 3;  // from kRightOne / 2 to kGrayOne
    store(value, gray);
    gray += gray_step;
    above = next;
  }
}

/// Derivatives across and down, smoothed along the other axis by 3, 10, 3 (Scharr). `gray` has
/// two rows and at least two columns more than the result, all numbers of columns are multiples of
/// kLanes. `sums` and `steps` have room for kLanes more than a row.
TOLMAN_WIDE_LANES
void derivatives(const std::int16_t* gray, int lanes, int side, int columns, std::int16_t* sums,
                 std::int16_t* steps, std::int16_t* by_x, std::int16_t* by_y) {
  for (int y = 0; y < side; ++y, gray += lanes, by_x += columns, by_y += columns) {
    for (int x = 0; x < lanes; x += kLanes) {
      const Shorts above = loadShorts(gray + x);
      const Shorts here = loadShorts(gray + lanes + x);
      const Shorts below = loadShorts(gray + 2 * lanes + x);
      const Shorts sum = 3 * (above + below) + 10 * here;  // at most 16 * 8 * 255, below 2^15
      store(sum, sums + x);
      store(below - above, steps + x);
    }
    for (int x = 0; x < columns; x += kLanes) {
      store((loadShorts(sums + x + 2) - loadShorts(sums + x)) >> 5, by_x + x);
      const Shorts beside = loadShorts(steps + x) + loadShorts(steps + x + 2);
      store((3 * beside + 10 * loadShorts(steps + x + 1)) >> 5, by_y + x);
    }
    for (int x = side; x < columns; ++x) by_x[x] = by_y[x] = 0;
  }
}

struct TwoSums {
  std::int64_t first = 0;
  std::int64_t second = 0;
};

/// Sums of a * c and b * c.
TOLMAN_WIDE_LANES
void addProducts(const std::int16_t* a, const std::int16_t* b, const std::int16_t* c, int count,
                 TwoSums& sums) {
  for (int start = 0; start < count; start += kExact) {
    const int end = std::min(count, start + kExact);
    std::int32_t first = 0;
    std::int32_t second = 0;
    for (int i = start; i < end; ++i) {
      first += a[i] * c[i];
      second += b[i] * c[i];
    }
    sums.first += first;
    sums.second += second;
  }
}

/// The same of the differences of c and d.
TOLMAN_WIDE_LANES
void addProductsOfDifferences(const std::int16_t* a, const std::int16_t* b, const std::int16_t* c,
                              const std::int16_t* d, int count, TwoSums& sums) {
  for (int start = 0; start < count; start += kExact) {
    const int end = std::min(count, start + kExact);
    std::int32_t first = 0;
    std::int32_t second = 0;
    for (int i = start; i < end; ++i) {
      const auto difference = static_cast<std::int16_t>(c[i] - d[i]);
      first += a[i] * difference;
      second += b[i] * difference;
    }
    sums.first += first;
    sums.second += second;
  }
}

/// Whether a patch around `centre` may be read.
bool isReadable(const PaddedImage& image, const cv::Point2f& centre) {
  return centre.x >= -1 && centre.y >= -1 && centre.x <= static_cast<float>(image.width) &&
         centre.y <= static_cast<float>(image.height);  // false for NaN
}

void interpolateAt(const PaddedImage& image, const cv::Point2f& corner, int rows, int columns,
                   std::int16_t* gray) {
  const float left = std::floor(corner.x);
  const float top = std::floor(corner.y);
  interpolate(image.at(static_cast<int>(left), static_cast<int>(top)), image.step, rows, columns,
              static_cast<int>((corner.x - left) * kRightOne + 0.5F),
              static_cast<int>((corner.y - top) * (kBelowOne - 1) + 0.5F), gray);
}

}  // namespace

void interpolate(const uchar* corner, std::ptrdiff_t step, int rows, int columns, int right,
                 int below, std::int16_t* gray) {
  for (int x = 0; x < columns; x += kLanes) {
    interpolateLanes(corner + x, step, rows, static_cast<std::int16_t>(right),
                     static_cast<std::int16_t>(below), gray + x, columns);
  }
}

Patch::Patch(int side)
    : side_(side),
      columns_(toLanes(side)),
      gray_(static_cast<std::size_t>(side * columns_)),
      by_x_(gray_.size()),
      by_y_(gray_.size()),
      buffer_(static_cast<std::size_t>((side + 2) * toLanes(side + 2))),
      sums_(static_cast<std::size_t>(toLanes(side + 2) + kLanes)),
      steps_(sums_.size()) {}

bool Patch::take(const PaddedImage& image, const cv::Point2f& centre) {
  if (!isReadable(image, centre)) return false;
  const float radius = radiusOf(side_);
  const int lanes = toLanes(side_ + 2);
  interpolateAt(image, centre - cv::Point2f(radius + 1, radius + 1), side_ + 2, lanes,
                buffer_.data());
  for (int y = 0; y < side_; ++y) {
    std::memcpy(gray_.data() + y * columns_, buffer_.data() + (y + 1) * lanes + 1,
                sizeof(std::int16_t) * static_cast<std::size_t>(std::min(columns_, lanes - 1)));
  }
  derivatives(buffer_.data(), lanes, side_, columns_, sums_.data(), steps_.data(), by_x_.data(),
              by_y_.data());
  const int count = side_ * columns_;
  TwoSums across;
  TwoSums down;
  addProducts(by_x_.data(), by_y_.data(), by_x_.data(), count, across);
  addProducts(by_x_.data(), by_y_.data(), by_y_.data(), count, down);
  const auto xx = static_cast<double>(across.first);
  const auto xy = static_cast<double>(across.second);
  const auto yy = static_cast<double>(down.second);
  const double smaller = 0.5 * (xx + yy - std::sqrt((xx - yy) * (xx - yy) + 4 * xy * xy));
  // Smaller eigenvalue of the structure tensor, mean over the pixels, (grey levels / px)^2. Chosen,
  // not tuned.
  constexpr double kWeakest = 0.1;
  if (smaller < kWeakest * kGrayOne * kGrayOne * side_ * side_) return false;
  const double determinant = xx * yy - xy * xy;
  inverse_[0] = yy / determinant;
  inverse_[1] = -xy / determinant;
  inverse_[2] = xx / determinant;
  return true;
}

bool Patch::align(const PaddedImage& image, cv::Point2f& centre, float tolerance) {
  constexpr int kMaxSteps = 30;  // chosen, not tuned; about three are usual
  const float radius = radiusOf(side_);
  cv::Point2f last(0, 0);
  for (int k = 0; k < kMaxSteps; ++k) {
    if (!isReadable(image, centre)) return false;
    interpolateAt(image, centre - cv::Point2f(radius, radius), side_, columns_, buffer_.data());
    TwoSums sums;
    addProductsOfDifferences(by_x_.data(), by_y_.data(), buffer_.data(), gray_.data(),
                             side_ * columns_, sums);
    const auto x = static_cast<double>(sums.first);
    const auto y = static_cast<double>(sums.second);
    const cv::Point2f step(static_cast<float>(inverse_[0] * x + inverse_[1] * y),
                           static_cast<float>(inverse_[1] * x + inverse_[2] * y));
    centre -= step;
    if (step.dot(step) <= tolerance * tolerance) break;
    const cv::Point2f swing = step + last;
    if (k > 0 && swing.dot(swing) <= tolerance * tolerance) {  // oscillates: the middle of the two
      centre += 0.5F * step;
      break;
    }
    last = step;
  }
  return isReadable(image, centre);
}

}  // namespace tolman::feature_stereo
