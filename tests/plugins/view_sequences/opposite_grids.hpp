// SPDX-License-Identifier: BSD-3-Clause
// Random grids of structure, and the same in the opposite direction.
#pragma once

#include "structure_grid.hpp"
#include "tolman/context.hpp"

namespace tolman::view_sequences::test {

/// Most cells are empty, as in a street.
inline StructureLevels randomGrid(RandomStream& random) {
  StructureLevels levels;
  for (std::uint8_t& level : levels) {
    level = static_cast<std::uint8_t>(random.below(4) == 0 ? 4 + random.below(12) : 0);
  }
  return levels;
}

/// What a camera in the opposite direction counts that stands `side` cells to the right and `front`
/// cells ahead. What the grid does not reach is empty.
inline StructureLevels seenTurned(const StructureLevels& street, int side, int front) {
  StructureLevels seen{};
  for (int i = 0; i < kLateral; ++i) {
    for (int j = 0; j < kAlong; ++j) {
      const int from_i = kLateral - 1 - i + side;
      const int from_j = kAlong - 1 - j + front;
      if (from_i < 0 || from_i >= kLateral || from_j < 0 || from_j >= kAlong) continue;
      for (int k = 0; k < kHeights; ++k) {
        seen[static_cast<std::size_t>((i * kAlong + j) * kHeights + k)] =
            street[static_cast<std::size_t>((from_i * kAlong + from_j) * kHeights + k)];
      }
    }
  }
  return seen;
}

}  // namespace tolman::view_sequences::test
