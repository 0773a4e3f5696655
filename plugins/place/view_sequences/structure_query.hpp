// SPDX-License-Identifier: BSD-3-Clause
// The present structure, turned by 180 degrees, prepared for the comparison with stored grids.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "structure_grid.hpp"

namespace tolman::view_sequences {

/// Largest shift to either side, cells: the other lane is two or three cells away. Chosen on
/// district.
inline constexpr int kStructureShift = 5;

class StructureQuery {
 public:
  StructureQuery(const StructureLevels& levels, const StructureMean& mean);

  /// 1 - cosine between the deviations from the mean, where the grids overlap at the best shift to
  /// the side; 0 to 2.
  float distanceTo(std::span<const std::uint8_t, kCells> stored) const;

 private:
  static constexpr int kShifts = 2 * kStructureShift + 1;
  using Fixed = std::array<std::int16_t, kCells>;  ///< levels in units of 1 / 64

  Fixed query_;                                  ///< turned deviation
  Fixed mean_;                                   ///< of the stored grids
  std::array<float, kShifts> with_mean_;         ///< inner products of query and mean
  std::array<float, kShifts> norms_;             ///< of the query
  std::array<float, kLateral> squares_of_mean_;  ///< of each slice
};

/// Position of the present camera in the coordinates of a stored grid of the opposite direction.
struct StructureFit {
  double correlation = -1;  ///< cosine between the deviations
  double lateral = 0;       ///< m to the right of the stored camera
  double ahead = 0;         ///< m in front of the stored camera
  bool within = false;      ///< neither shift is the largest that was tried
};

/// Peak of the parabola through three values at -1, 0 and 1; the middle one is the largest.
double peakOf(double before, double at, double after);

/// Both are deviations from the mean; `query` is turned already.
StructureFit fitStructure(const StructureDeviation& query, const StructureDeviation& stored);

}  // namespace tolman::view_sequences
