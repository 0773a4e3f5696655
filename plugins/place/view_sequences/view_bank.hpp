// SPDX-License-Identifier: BSD-3-Clause
// The stored views, in the order in which they were driven. What all views of a pass have in common
// (lens, bonnet, light, season) has no information about the place. So each view is compared by its
// deviation from a mean, which is stored for chunks of 64 views: the mean of the chunk and its two
// neighbours of the same pass.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "edge_grid.hpp"
#include "tolman/state_stream.hpp"

namespace tolman::view_sequences {

/// Consecutive views of one pass with the mean that they deviate from.
struct Chunk {
  std::int64_t first = 0;
  std::int64_t count = 0;
  std::int64_t pass = 0;
  std::array<std::uint8_t, kValues> mean{};  ///< in units of 1 / kMeanScale levels
};
inline constexpr float kMeanScale = 16;  // so that 15 levels fit a byte

class ViewBank {
 public:
  /// Adds a view; its index is the number of earlier views. `path`: m driven so far.
  void add(const PackedView& view, double path);
  /// The next view belongs to another pass: it begins a new chunk, whose mean does not include
  /// earlier passes.
  void beginPass() { ++pass_; }

  std::int64_t size() const { return static_cast<std::int64_t>(paths_.size()); }
  std::span<const std::uint8_t> view(std::int64_t i) const {
    return {views_.data() + static_cast<std::size_t>(i) * kPackedBytes, kPackedBytes};
  }
  double path(std::int64_t i) const { return paths_[static_cast<std::size_t>(i)]; }
  /// Norm of the deviation from the mean of the chunk, levels.
  float deviation(std::int64_t i) const { return deviations_[static_cast<std::size_t>(i)]; }
  const std::vector<Chunk>& chunks() const { return chunks_; }
  /// Whether the mean of chunk `c` will not change any more.
  bool isSettled(std::size_t c) const;

  void save(StateWriter& writer) const;
  /// False for a damaged state.
  bool load(StateReader& reader);

 private:
  void refresh(std::size_t chunk);

  std::vector<std::uint8_t> views_;
  std::vector<float> deviations_;
  std::vector<float> paths_;
  std::vector<Chunk> chunks_;
  std::int64_t pass_ = 0;
};

// The current view, prepared for the comparison with stored views: its deviation from the mean of
// this pass, for every horizontal shift that is tried.

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
