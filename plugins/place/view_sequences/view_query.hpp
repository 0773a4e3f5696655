// SPDX-License-Identifier: BSD-3-Clause
// The current view, prepared for the comparison with stored views: its deviation from the mean of
// this pass, for every horizontal shift that is tried.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "view_bank.hpp"

namespace tolman::view_sequences {

/// Largest shift to either side, in cells of the edge grid: a quarter of its 13 columns. Chosen,
/// not tuned; docs/report/places.md shows the effect of no shift.
inline constexpr int kShift = 3;
inline constexpr int kShifts = 2 * kShift + 1;

struct ViewDistance {
  float distance = 2;  ///< 1 - cosine between the deviations at the best shift; 0 to 2
  int shift = 0;       ///< by how many cells the scene is further left than in the stored view
};

class ViewQuery {
 public:
  /// Both in levels, the units of stored values (unpack()).
  ViewQuery(const EdgeValues& view, const EdgeValues& mean_of_pass);

  /// Inner products of the deviation with the mean of a chunk of views, one for each shift.
  using ChunkProducts = std::array<float, kShifts>;
  ChunkProducts productsWith(const Chunk& chunk) const;

  /// Distance to a stored view that deviates by `deviation` from the mean of its chunk.
  ViewDistance distanceTo(std::span<const std::int16_t, kValues> levels,
                          const ChunkProducts& of_chunk, float deviation) const;
  /// Distances of all shifts, as distanceTo().
  std::array<float, kShifts> distances(std::span<const std::int16_t, kValues> levels,
                                       const ChunkProducts& of_chunk, float deviation) const;

  /// The deviation of the view, levels.
  const EdgeValues& deviation() const { return deviation_; }

 private:
  EdgeValues deviation_;
  std::array<std::int16_t, kValues> fixed_;  ///< deviation_ in units of 1 / kFixedScale
  std::array<float, kShifts> scales_;        ///< factors from inner products to cosines
};

}  // namespace tolman::view_sequences
