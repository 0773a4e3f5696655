// SPDX-License-Identifier: BSD-3-Clause
// The probability of a place, from its cost and that of its rivals.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace tolman::view_sequences {

/// Largest difference of the indices of two stored views that show the same place. Chosen, not
/// tuned.
inline constexpr std::int64_t kSamePlace = 10;
/// Largest distance (m) between a place and a pose that its landmarks measure. Views with landmarks
/// are 4 m apart, so one of them is nearer. Chosen on the town's 06 and 07, where all poses beyond
/// 15 m were of views further along the same street, with errors of metres.
inline constexpr double kFarthestPose = 6;
/// Cost of the hypothesis that the robot is at no known place. Chosen on the same data as
/// kNatsPerCost.
inline constexpr double kCostOfNovelty = -4;

/// Posterior probability of the place with this cost (lower: more likely) against the alternatives
/// whose costs are `rivals`: the best other place, the views of 10 to 20 m ago, and no known place.
/// kNatsPerCost was chosen on 1,241 right and 724 wrong best places of campus walks
/// (places_gardens, six pairs of passes, whole and in halves) and on two drives in the town (06,
/// 07); checked on a corridor (places_two_laps) and the drives 00 and 05.
inline double probabilityOf(double cost, std::initializer_list<double> rivals) {
  constexpr double kNatsPerCost = 0.7;
  double odds_against = 0;
  for (const double rival : rivals) odds_against += std::exp(kNatsPerCost * (cost - rival));
  return 1 / (1 + odds_against);
}

}  // namespace tolman::view_sequences
