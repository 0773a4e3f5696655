// SPDX-License-Identifier: BSD-3-Clause
#include "structure_query.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "wide_lanes.hpp"

namespace tolman::view_sequences {
namespace {

constexpr float kStructureScale = 64;  // deviations are within 15 levels: products fit 32 bits

/// The part of one axis in which two grids overlap when the query is moved by `shift` cells.
struct SideOverlap {
  int query;
  int stored;
  int count;
};

SideOverlap overlapOf(int shift, int cells) {
  return {std::max(0, -shift), std::max(0, shift), cells - std::abs(shift)};
}

std::int16_t fixedLevel(float value) {
  return static_cast<std::int16_t>(std::lround(kStructureScale * value));
}

/// Inner product in integers, so that the order of summation does not matter.
TOLMAN_WIDE_LANES std::int32_t product(const std::int16_t* a, const std::uint8_t* b, int count) {
  std::int32_t sum = 0;
  for (int i = 0; i < count; ++i) sum += a[i] * b[i];
  return sum;
}

double product(const std::int16_t* a, const std::int16_t* b, int count) {
  std::int64_t sum = 0;
  for (int i = 0; i < count; ++i) sum += a[i] * b[i];
  return static_cast<double>(sum) / (kStructureScale * kStructureScale);
}

/// Sums of products of a slice with the mean and with itself.
struct SliceSums {
  std::int32_t with_mean = 0;
  std::int32_t squares = 0;
};

TOLMAN_WIDE_LANES SliceSums sliceSums(const std::int16_t* mean, const std::uint8_t* stored) {
  SliceSums sums;
  for (int i = 0; i < kSlice; ++i) {
    sums.with_mean += mean[i] * stored[i];
    sums.squares += stored[i] * stored[i];
  }
  return sums;
}

}  // namespace

StructureQuery::StructureQuery(const StructureLevels& levels, const StructureMean& mean) {
  const StructureDeviation query = turned(mean.deviationOf(levels));
  std::ranges::transform(query, query_.begin(), fixedLevel);
  std::ranges::transform(mean.mean(), mean_.begin(), fixedLevel);
  for (int s = 0; s < kShifts; ++s) {
    const SideOverlap part = overlapOf(s - kStructureShift, kLateral);
    const std::int16_t* of_query = query_.data() + part.query * kSlice;
    const int count = part.count * kSlice;
    const auto i = static_cast<std::size_t>(s);
    with_mean_[i] =
        static_cast<float>(product(of_query, mean_.data() + part.stored * kSlice, count));
    norms_[i] = static_cast<float>(std::sqrt(product(of_query, of_query, count)));
  }
  for (int c = 0; c < kLateral; ++c) {
    const std::int16_t* slice = mean_.data() + c * kSlice;
    squares_of_mean_[static_cast<std::size_t>(c)] =
        static_cast<float>(product(slice, slice, kSlice));
  }
}

float StructureQuery::distanceTo(std::span<const std::uint8_t, kCells> stored) const {
  // Cumulative squared norms of the stored deviation, by slice.
  std::array<float, kLateral + 1> before;
  before[0] = 0;
  for (int c = 0; c < kLateral; ++c) {
    const SliceSums sums = sliceSums(mean_.data() + c * kSlice, stored.data() + c * kSlice);
    const auto i = static_cast<std::size_t>(c);
    before[i + 1] = before[i] + static_cast<float>(sums.squares) -
                    2 * static_cast<float>(sums.with_mean) / kStructureScale + squares_of_mean_[i];
  }
  float best = 2;
  for (int s = 0; s < kShifts; ++s) {
    const SideOverlap part = overlapOf(s - kStructureShift, kLateral);
    const auto i = static_cast<std::size_t>(s);
    const auto first = static_cast<std::size_t>(part.stored);
    const float squares = before[first + static_cast<std::size_t>(part.count)] - before[first];
    const float norm = norms_[i] * std::sqrt(std::max(squares, 0.0F));
    const auto sum =
        static_cast<float>(product(query_.data() + part.query * kSlice,
                                   stored.data() + part.stored * kSlice, part.count * kSlice));
    if (norm > 0) best = std::min(best, 1 - (sum / kStructureScale - with_mean_[i]) / norm);
  }
  return best;
}

}  // namespace tolman::view_sequences
