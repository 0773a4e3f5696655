// SPDX-License-Identifier: BSD-3-Clause
// The standardised value z of a distance: its difference from the mean of all distances of a step,
// in standard deviations.
#pragma once

#include <algorithm>

#include "statistics.hpp"

namespace tolman::view_sequences {

class UsualDistance {
 public:
  explicit UsualDistance(const Sums& sums)
      : mean_(sums.mean()), deviation_(sums.deviationWithPrior(kPriorViews, kPriorDeviation)) {}

  /// Negative: more alike than usual.
  float standardised(float distance) const {
    return std::max(static_cast<float>((distance - mean_) / deviation_), -kLargest);
  }

 private:
  // Prior of the standard deviation, with the weight of kPriorViews views: that of distances
  // between different places (campus walks, day and night). Grids of structure use the same.
  static constexpr double kPriorDeviation = 0.12;
  static constexpr double kPriorViews = 20;
  // Limits the effect of a single view, however similar. Chosen on the walks and a corridor
  // (docs/report/places.md).
  static constexpr float kLargest = 4;

  double mean_;
  double deviation_;
};

}  // namespace tolman::view_sequences
