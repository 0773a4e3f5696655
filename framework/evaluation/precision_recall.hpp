// SPDX-License-Identifier: BSD-3-Clause
// Precision and recall of claims that a place was seen before, over all thresholds on their score.
#pragma once

#include <cstdint>
#include <vector>

namespace tolman::evaluation {

/// `query` shows the place of the earlier image `place`.
struct PlaceClaim {
  std::int64_t query = -1;
  std::int64_t place = -1;
  double score = 0;  ///< a smaller score is more certain
  bool right = false;
};

/// Precision and recall if only claims with at most this score are made.
struct PrecisionRecall {
  double score = 0;
  std::int64_t claims = 0;
  double precision = 1;  ///< share of the claims that are right
  double recall = 0;     ///< number of right claims over number of findable queries
};

/// One point for each score, ascending. `findable`: number of queries that have a true place.
std::vector<PrecisionRecall> precisionRecall(std::vector<PlaceClaim> claims, std::int64_t findable);

/// Largest recall at which the precision is at least `precision`; 0 where it never is.
double recallAt(const std::vector<PrecisionRecall>& curve, double precision);

}  // namespace tolman::evaluation
