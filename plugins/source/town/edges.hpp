// SPDX-License-Identifier: BSD-3-Clause
// Pixels that need more rays than one, because their neighbours show something else.
#pragma once

#include <cstdint>
#include <vector>

namespace tolman::town {

/// What the first rays of an image found, row-major.
struct FirstLook {
  const std::vector<float>& radiance;
  const std::vector<float>& depth;         ///< 0 for sky
  const std::vector<std::uint32_t>& seen;  ///< Shaded::seen
  int width;
  int height;
};

/// Sets `edges` of the pixels of a row: 1 where a neighbour above, below or beside differs in
/// radiance and belongs to another object, light or plane.
void findEdges(const FirstLook& look, int row, std::uint32_t* edges);

}  // namespace tolman::town
