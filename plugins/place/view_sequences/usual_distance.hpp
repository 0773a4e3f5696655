// SPDX-License-Identifier: BSD-3-Clause
// How unusual a distance is among all that were compared at a step: its standardised value z.
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
  // Distances of different places have about this standard deviation (campus walks, day and night);
  // it counts as much as so many views until there are more. Grids of structure take the same.
  static constexpr double kPriorDeviation = 0.12;
  static constexpr double kPriorViews = 20;
  // One view alone, however alike, must not decide.
  static constexpr float kLargest = 4;

  double mean_;
  double deviation_;
};

}  // namespace tolman::view_sequences
