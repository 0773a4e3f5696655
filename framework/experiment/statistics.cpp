// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tolman/context.hpp"

namespace tolman::experiment {
namespace {

constexpr std::size_t kResamples = 10'000;

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Twice the rank (from 1) of each value. Equal values share their mean rank, so only twice the
/// rank is an integer.
std::vector<std::size_t> doubleRanks(const std::vector<double>& sizes) {
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return sizes[i]; });
  std::vector<std::size_t> ranks(sizes.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && sizes[order[end]] == sizes[order[begin]]) ++end;
    for (std::size_t i = begin; i < end; ++i) ranks[order[i]] = begin + 1 + end;
    begin = end;
  }
  return ranks;
}

/// The probability of each sum of a random choice of `steps`, each taken with probability 1/2.
std::vector<double> sumDistribution(const std::vector<std::size_t>& steps) {
  std::vector<double> probability = {1};
  for (const std::size_t step : steps) {
    std::vector<double> next(probability.size() + step, 0.0);
    for (std::size_t sum = 0; sum < probability.size(); ++sum) {
      next[sum] += probability[sum] / 2;
      next[sum + step] += probability[sum] / 2;
    }
    probability = std::move(next);
  }
  return probability;
}

}  // namespace

double quantile(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Summary summaryOf(std::vector<double> values) {
  Summary summary;
  if (values.empty()) return summary;
  std::ranges::sort(values);
  summary.n = values.size();
  summary.mean = meanOf(values);
  summary.median = quantile(values, 0.5);
  summary.low = values.front();
  summary.high = values.back();
  if (values.size() < 2) return summary;
  double squares = 0;
  for (const double value : values) squares += (value - summary.mean) * (value - summary.mean);
  summary.deviation = std::sqrt(squares / static_cast<double>(values.size() - 1));
  return summary;
}

Interval bootstrapMean(const std::vector<std::vector<double>>& groups, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<double> means;
  means.reserve(kResamples);
  for (std::size_t i = 0; i < kResamples; ++i) {
    double sum = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const auto& group = groups.size() == 1 ? groups[0] : groups[random.below(groups.size())];
      double within = 0;
      for (std::size_t k = 0; k < group.size(); ++k) within += group[random.below(group.size())];
      sum += within / static_cast<double>(group.size());
    }
    means.push_back(sum / static_cast<double>(groups.size()));
  }
  std::ranges::sort(means);
  return {quantile(means, 0.025), quantile(means, 0.975)};
}

SignedRank signedRank(const std::vector<double>& differences) {
  std::vector<double> kept;
  for (const double d : differences) {
    if (d != 0) kept.push_back(d);
  }
  SignedRank result;
  result.n = kept.size();
  if (kept.empty()) return result;
  std::vector<double> sizes;
  for (const double d : kept) sizes.push_back(std::abs(d));
  const std::vector<std::size_t> ranks = doubleRanks(sizes);
  std::size_t positive = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) positive += kept[i] > 0 ? ranks[i] : 0;
  const std::vector<double> probability = sumDistribution(ranks);
  const std::size_t all = probability.size() - 1;
  const std::size_t smaller = std::min(positive, all - positive);
  double tail = 0;
  for (std::size_t sum = 0; sum <= smaller; ++sum) tail += probability[sum];
  result.p = std::min(1.0, 2 * tail);
  result.effect =
      (2.0 * static_cast<double>(positive) - static_cast<double>(all)) / static_cast<double>(all);
  return result;
}

}  // namespace tolman::experiment
