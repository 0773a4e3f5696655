// SPDX-License-Identifier: BSD-3-Clause
// Random views: as levels, as a path of places, and with noise.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "edge_grid.hpp"
#include "tolman/context.hpp"

namespace tolman::view_sequences::test {

/// The values that levels 0 to 15 stand for in `packed()`.
inline PackedView packedLevels(const EdgeValues& levels) {
  EdgeValues values;
  for (std::size_t i = 0; i < kValues; ++i) values[i] = levels[i] / kLevelsPerUnit;
  return packed(values);
}

inline EdgeValues levelsOf(std::span<const std::uint8_t> view) {
  std::array<std::int16_t, kValues> levels;
  unpack(view, levels);
  EdgeValues values;
  for (std::size_t i = 0; i < kValues; ++i) values[i] = levels[i];
  return values;
}

/// Whole levels, each by chance.
inline EdgeValues randomLevels(RandomStream& random) {
  EdgeValues levels;
  for (float& level : levels) level = static_cast<float>(random.below(16));
  return levels;
}

/// The view as it looks another time: whole levels with normal noise of `deviation` levels.
inline EdgeValues withNoise(const EdgeValues& levels, double deviation, RandomStream& random) {
  EdgeValues noisy;
  for (std::size_t i = 0; i < kValues; ++i) {
    const double level = std::round(levels[i] + deviation * random.normal());
    noisy[i] = static_cast<float>(std::clamp(level, 0.0, 15.0));
  }
  return noisy;
}

/// Different views that have something in common, as those of one camera have.
inline std::vector<EdgeValues> randomPath(int views, RandomStream& random) {
  EdgeValues common;
  for (float& level : common) level = static_cast<float>(random.uniform(3, 12));
  std::vector<EdgeValues> path;
  for (int i = 0; i < views; ++i) path.push_back(withNoise(common, 3, random));
  return path;
}

/// What a camera sees whose scene moved to the left by `cells`; the rest by chance.
inline EdgeValues movedLeft(const EdgeValues& levels, int cells, RandomStream& random) {
  EdgeValues moved;
  for (int c = 0; c < kColumns; ++c) {
    const int from = c + cells;
    for (int i = 0; i < kColumnValues; ++i) {
      const auto to = static_cast<std::size_t>(c * kColumnValues + i);
      moved[to] = from >= 0 && from < kColumns
                      ? levels[static_cast<std::size_t>(from * kColumnValues + i)]
                      : static_cast<float>(random.below(16));
    }
  }
  return moved;
}

}  // namespace tolman::view_sequences::test
