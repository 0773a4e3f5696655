// SPDX-License-Identifier: BSD-3-Clause
// Appearance of a view: strength of edges in six directions over a grid of 13 x 8 cells, each
// normalised by its neighbourhood (histograms of oriented gradients, Dalal and Triggs, CVPR 2005;
// square root by Arandjelovic and Zisserman, CVPR 2012). It depends little on illumination.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "tolman/image.hpp"
#include "tolman/state_stream.hpp"

namespace tolman::view_sequences {

/// Chosen, not tuned.
inline constexpr int kColumns = 13;
inline constexpr int kRows = 8;
inline constexpr int kDirections = 6;  ///< over 180 degrees: the sign of a gradient is ignored
inline constexpr int kColumnValues = kRows * kDirections;
inline constexpr int kValues = kColumns * kColumnValues;

/// Index (column * kRows + row) * kDirections + direction, so that a horizontal shift by a cell is
/// a contiguous part.
using EdgeValues = std::array<float, kValues>;

/// False for a view without edges, such as a blank or covered one; `values` is not changed.
bool edgeGrid(const Image& image, EdgeValues& values);

/// Four bits for each value, two of a column in one byte: 312 bytes a view.
inline constexpr int kPackedBytes = kValues / 2;
using PackedView = std::array<std::uint8_t, kPackedBytes>;
/// Values are stored in units of 1 / kLevelsPerUnit, from 0 to 15; larger ones are clipped.
inline constexpr float kLevelsPerUnit = 10;

PackedView packed(const EdgeValues& values);
/// Levels 0 to 15, in the order of EdgeValues.
void unpack(std::span<const std::uint8_t> view, std::span<std::int16_t, kValues> levels);

// Running mean of about the last hundred views: what lens, light and season have in common in all
// of them.

class MeanView {
 public:
  /// Adds a view: the mean of the first hundred views, then an exponentially weighted mean, which
  /// follows changes of light.
  void add(const EdgeValues& view) {
    weight_ = std::min(weight_ + 1, kViews);
    for (std::size_t i = 0; i < kValues; ++i) mean_[i] += (view[i] - mean_[i]) / weight_;
  }
  /// The light may be different in the next pass, so the mean so far counts as only 20 views.
  void beginPass() {
    constexpr float kCarried = 20;  // chosen, not tuned
    weight_ = std::min(weight_, kCarried);
  }
  const EdgeValues& mean() const { return mean_; }

  void save(StateWriter& writer) const {
    writer.put(weight_);
    writer.putAll<float>(mean_);
  }
  /// False for a damaged state.
  bool load(StateReader& reader) {
    weight_ = reader.get<float>();
    reader.getAll<float>(mean_);
    return weight_ >= 0 && weight_ <= kViews &&
           std::ranges::all_of(mean_, [](float level) { return level >= 0 && level <= 15; });
  }

 private:
  static constexpr float kViews = 100;  // chosen, not tuned

  EdgeValues mean_{};
  float weight_ = 0;
};

}  // namespace tolman::view_sequences
