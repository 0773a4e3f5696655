// SPDX-License-Identifier: BSD-3-Clause
#include "view_query.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "wide_lanes.hpp"

namespace tolman::view_sequences {
namespace {

// Deviations are within 15 levels: products of 624 values with levels fit 32 bits.
constexpr float kFixedScale = 64;

/// The overlap of the view and a stored view at one shift, as indices of values.
struct Overlap {
  int view;
  int stored;
  int count;
};

Overlap overlapAt(int index) {
  const int shift = index - kShift;
  return {std::max(0, -shift) * kColumnValues, std::max(0, shift) * kColumnValues,
          (kColumns - std::abs(shift)) * kColumnValues};
}

/// In integers, so that the order of summation does not matter.
TOLMAN_WIDE_LANES std::int32_t innerProduct(const std::int16_t* a, const std::int16_t* b,
                                            int count) {
  std::int32_t sum = 0;
  for (int i = 0; i < count; ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

ViewQuery::ViewQuery(const EdgeValues& view, const EdgeValues& mean_of_pass) {
  for (std::size_t i = 0; i < kValues; ++i) {
    deviation_[i] = std::clamp(view[i] - mean_of_pass[i], -15.0F, 15.0F);
    fixed_[i] = static_cast<std::int16_t>(std::lround(deviation_[i] * kFixedScale));
  }
  for (int s = 0; s < kShifts; ++s) {
    const Overlap part = overlapAt(s);
    const std::int16_t* values = fixed_.data() + part.view;
    const double squares =
        innerProduct(values, values, part.count) / static_cast<double>(kFixedScale * kFixedScale);
    // The stored norm is that of all columns; it is scaled to the share of the overlap.
    const double share = std::sqrt(static_cast<double>(kValues) / part.count);
    scales_[static_cast<std::size_t>(s)] =
        squares > 0 ? static_cast<float>(share / std::sqrt(squares)) : 0;
  }
}

ViewQuery::ChunkProducts ViewQuery::productsWith(const Chunk& chunk) const {
  std::array<std::int16_t, kValues> mean;
  std::copy(chunk.mean.begin(), chunk.mean.end(), mean.begin());
  ChunkProducts products;
  for (int s = 0; s < kShifts; ++s) {
    const Overlap part = overlapAt(s);
    products[static_cast<std::size_t>(s)] =
        static_cast<float>(
            innerProduct(fixed_.data() + part.view, mean.data() + part.stored, part.count)) /
        (kFixedScale * kMeanScale);
  }
  return products;
}

std::array<float, kShifts> ViewQuery::distances(std::span<const std::int16_t, kValues> levels,
                                                const ChunkProducts& of_chunk,
                                                float deviation) const {
  std::array<float, kShifts> distances;
  for (int s = 0; s < kShifts; ++s) {
    const auto i = static_cast<std::size_t>(s);
    const Overlap part = overlapAt(s);
    const float product = static_cast<float>(innerProduct(
                              fixed_.data() + part.view, levels.data() + part.stored, part.count)) /
                          kFixedScale;
    distances[i] = deviation > 0 ? 1 - (product - of_chunk[i]) * scales_[i] / deviation : 1;
  }
  return distances;
}

ViewDistance ViewQuery::distanceTo(std::span<const std::int16_t, kValues> levels,
                                   const ChunkProducts& of_chunk, float deviation) const {
  const auto all = distances(levels, of_chunk, deviation);
  const auto best = std::ranges::min_element(all);
  return {*best, static_cast<int>(best - all.begin()) - kShift};
}

}  // namespace tolman::view_sequences
