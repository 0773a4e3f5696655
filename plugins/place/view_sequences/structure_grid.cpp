// SPDX-License-Identifier: BSD-3-Clause
#include "structure_grid.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace tolman::view_sequences
