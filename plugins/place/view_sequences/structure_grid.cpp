// SPDX-License-Identifier: BSD-3-Clause
#include "structure_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "wide_lanes.hpp"

namespace tolman::view_sequences {

namespace {

// Limits of the bands, m above the street. Lower points are the street itself. Chosen on the town's
// `district`.
constexpr std::array<float, kHeights + 1> kLimits = {0.4F, 1.2F, 2.2F, 3.5F, 5.5F, 8.0F, 30.0F};
// Height of the camera above the street, m: that of KITTI's car. Another height shifts all bands
// equally, in stored grids and in the present one.
constexpr float kCameraHeight = 1.65F;
// Levels per unit of the natural logarithm: level 15 means 1,408 points or more.
constexpr double kLevelsPerLog = 2;

}  // namespace

void StructureCounts::add(const Eigen::Vector3f& point) {
  const float height = kCameraHeight - point.y();
  const float lateral = point.x() / kCellSize + 0.5F * kLateral;
  const float along = point.z() / kCellSize + 0.5F * kAlong;
  const bool within = lateral >= 0 && lateral < kLateral && along >= 0 && along < kAlong &&
                      height >= kLimits.front() && height < kLimits.back();
  if (!within) return;
  int band = 0;
  while (height >= kLimits[static_cast<std::size_t>(band) + 1]) ++band;
  const int cell = static_cast<int>(lateral) * kAlong + static_cast<int>(along);
  ++counts_[static_cast<std::size_t>(cell * kHeights + band)];
  ++points_;
}

StructureLevels StructureCounts::levels() const {
  StructureLevels levels;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double level = kLevelsPerLog * std::log1p(static_cast<double>(counts_[i]));
    levels[i] = static_cast<std::uint8_t>(std::min(std::lround(level), 15L));
  }
  return levels;
}

StructureDeviation turned(const StructureDeviation& deviation) {
  StructureDeviation result;
  for (int cell = 0; cell < kLateral * kAlong; ++cell) {
    // Both axes are reversed, so the order of cells is reversed; that of the heights is not.
    const int from = kLateral * kAlong - 1 - cell;
    std::copy_n(deviation.begin() + from * kHeights, kHeights, result.begin() + cell * kHeights);
  }
  return result;
}

void StructureMean::add(const StructureLevels& levels) {
  ++count_;
  const float share = 1.0F / static_cast<float>(count_);
  for (std::size_t i = 0; i < levels.size(); ++i) mean_[i] += (levels[i] - mean_[i]) * share;
}

StructureDeviation StructureMean::deviationOf(const StructureLevels& levels) const {
  StructureDeviation deviation;
  for (std::size_t i = 0; i < levels.size(); ++i) deviation[i] = levels[i] - mean_[i];
  return deviation;
}

void StructureMean::save(StateWriter& writer) const {
  writer.put(count_);
  writer.putAll<float>(mean_);
}

bool StructureMean::load(StateReader& reader) {
  count_ = reader.get<std::int64_t>();
  reader.getAll<float>(mean_);
  return count_ >= 0 &&
         std::ranges::all_of(mean_, [](float level) { return level >= 0 && level <= 15; });
}

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

namespace {

constexpr int kSide = 6;   // largest shift to the side, cells; chosen, not tuned
constexpr int kFront = 4;  // largest shift along the street, cells; chosen, not tuned

using Correlations = std::array<std::array<double, 2 * kFront + 1>, 2 * kSide + 1>;

/// Cosine of the deviations where the grids overlap, with the query moved by so many cells.
double correlationAt(const StructureDeviation& query, const StructureDeviation& stored, int side,
                     int front) {
  const int count = (kAlong - std::abs(front)) * kHeights;
  double products = 0;
  double squares_of_query = 0;
  double squares_of_stored = 0;
  for (int c = std::max(0, side); c < std::min(kLateral, kLateral + side); ++c) {
    const float* s = stored.data() + c * kSlice + std::max(0, front) * kHeights;
    const float* q = query.data() + (c - side) * kSlice + std::max(0, -front) * kHeights;
    for (int i = 0; i < count; ++i) {
      products += static_cast<double>(q[i]) * s[i];
      squares_of_query += static_cast<double>(q[i]) * q[i];
      squares_of_stored += static_cast<double>(s[i]) * s[i];
    }
  }
  const double norm = std::sqrt(squares_of_query * squares_of_stored);
  return norm > 0 ? products / norm : -1;
}

}  // namespace

double peakOf(double before, double at, double after) {
  const double curve = before - 2 * at + after;
  return curve < 0 ? 0.5 * (before - after) / curve : 0;
}

StructureFit fitStructure(const StructureDeviation& query, const StructureDeviation& stored) {
  Correlations all;
  std::size_t side = 0;
  std::size_t front = 0;
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = 0; b < all[a].size(); ++b) {
      all[a][b] =
          correlationAt(query, stored, static_cast<int>(a) - kSide, static_cast<int>(b) - kFront);
      if (all[a][b] > all[side][front]) {
        side = a;
        front = b;
      }
    }
  }
  StructureFit fit;
  fit.correlation = all[side][front];
  fit.within = side > 0 && side + 1 < all.size() && front > 0 && front + 1 < all[side].size();
  fit.lateral = static_cast<double>(side) - kSide;
  fit.ahead = static_cast<double>(front) - kFront;
  if (fit.within) {
    fit.lateral += peakOf(all[side - 1][front], fit.correlation, all[side + 1][front]);
    fit.ahead += peakOf(all[side][front - 1], fit.correlation, all[side][front + 1]);
  }
  fit.lateral *= kCellSize;
  fit.ahead *= kCellSize;
  return fit;
}

}  // namespace tolman::view_sequences
