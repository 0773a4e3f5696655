// SPDX-License-Identifier: BSD-3-Clause
// Running mean of about the last hundred views: what lens, light and season have in common in all
// of them.
#pragma once

#include <algorithm>

#include "edge_grid.hpp"
#include "tolman/state_stream.hpp"

namespace tolman::view_sequences {

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
