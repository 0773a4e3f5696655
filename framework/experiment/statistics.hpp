// SPDX-License-Identifier: BSD-3-Clause
// Statistics of repeated runs: centre and spread, bootstrap intervals, Wilcoxon's signed rank test.
#pragma once

#include <cstdint>
#include <vector>

namespace tolman::experiment {

struct Summary {
  std::size_t n = 0;
  double mean = 0;
  double median = 0;
  double deviation = 0;  ///< standard deviation, n - 1; 0 for one value
  double low = 0;        ///< smallest value
  double high = 0;
};
Summary summaryOf(std::vector<double> values);

/// The quantile, interpolated between the two nearest sorted values (numpy's default method).
double quantile(const std::vector<double>& sorted, double share);

struct Interval {
  double low = 0;
  double high = 0;
};

/// The 95 % percentile interval of the mean by the bootstrap (Efron 1979), from 10,000 resamples.
/// With several groups (sequences) a resample draws groups with replacement, then values (seeds)
/// within each group with replacement; its mean is the mean of the group means. Groups must not be
/// empty.
Interval bootstrapMean(const std::vector<std::vector<double>>& groups, std::uint64_t seed);

struct SignedRank {
  std::size_t n = 0;  ///< differences that are not zero
  double p = 1;  ///< two-sided, exact (over all signs of the ranks); ties share their mean rank
  double effect = 0;  ///< matched-pairs rank-biserial correlation, -1 to 1 (Kerby 2014)
};
/// Wilcoxon's signed rank test of differences against zero. Zeros are left out (Wilcoxon 1945).
/// At most 1000 differences.
SignedRank signedRank(const std::vector<double>& differences);

}  // namespace tolman::experiment
