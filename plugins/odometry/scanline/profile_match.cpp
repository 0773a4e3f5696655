// SPDX-License-Identifier: BSD-3-Clause
#include "profile_match.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

namespace tolman::scanline {
namespace {

double meanOf(std::span<const float> values) {
  double sum = 0;
  for (const float value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Mean absolute difference after subtracting the means, when the scene moved right by `shift`.
double differenceAt(const Profile& earlier, const Profile& later, int shift) {
  const std::size_t overlap = earlier.size() - static_cast<std::size_t>(std::abs(shift));
  const auto a = std::span(earlier).subspan(shift < 0 ? std::size_t(-shift) : 0, overlap);
  const auto b = std::span(later).subspan(shift > 0 ? std::size_t(shift) : 0, overlap);
  const auto brighter = static_cast<float>(meanOf(b) - meanOf(a));
  double sum = 0;
  for (std::size_t i = 0; i < overlap; ++i) sum += std::abs(b[i] - a[i] - brighter);
  return sum / static_cast<double>(overlap);
}

/// Position of the tip of a V with equal slopes through the costs at -1, 0 and 1; that at 0 is the
/// smallest.
double tipOfV(double before, double least, double after) {
  const double rise = std::max(before, after) - least;
  return rise > 0 ? 0.5 * (before - after) / rise : 0;
}

/// Half the width of the range around `best` with costs below a level between the best and the mean
/// cost, a tenth above the best.
double basin(const std::vector<double>& costs, std::size_t best) {
  double mean = 0;
  for (const double cost : costs) mean += cost / static_cast<double>(costs.size());
  const double level = costs[best] + 0.1 * (mean - costs[best]);  // chosen, not tuned
  std::size_t first = best;
  std::size_t last = best;
  for (std::size_t i = 0; i < costs.size(); ++i) {  // other minima too: any may be the true one
    if (costs[i] > level) continue;
    first = std::min(first, i);
    last = std::max(last, i);
  }
  return 0.5 * static_cast<double>(last - first);
}

}  // namespace

ProfileMatch matchProfiles(const Profile& earlier, const Profile& later, int largest_shift) {
  const int largest = std::min(largest_shift, static_cast<int>(earlier.size() / 2));
  std::vector<double> costs;
  std::size_t best = static_cast<std::size_t>(largest);  // no shift
  for (int shift = -largest; shift <= largest; ++shift) {
    costs.push_back(differenceAt(earlier, later, shift));
  }
  const auto distance = [&](std::size_t i) { return std::abs(static_cast<int>(i) - largest); };
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const bool closer = costs[i] == costs[best] && distance(i) < distance(best);
    if (costs[i] < costs[best] || closer) best = i;
  }
  ProfileMatch match;
  match.moved_right = static_cast<double>(best) - largest;
  match.difference = costs[best];
  match.uncertainty = basin(costs, best);
  match.compared = static_cast<int>(earlier.size()) - distance(best);
  if (best > 0 && best + 1 < costs.size()) {
    match.moved_right += tipOfV(costs[best - 1], costs[best], costs[best + 1]);
  }
  return match;
}

}  // namespace tolman::scanline
