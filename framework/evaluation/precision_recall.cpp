// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/precision_recall.hpp"

#include <algorithm>

namespace tolman::evaluation {

std::vector<PrecisionRecall> precisionRecall(std::vector<PlaceClaim> claims,
                                             std::int64_t findable) {
  std::ranges::stable_sort(claims, {}, &PlaceClaim::score);
  std::vector<PrecisionRecall> curve;
  std::int64_t right = 0;
  for (std::size_t i = 0; i < claims.size(); ++i) {
    right += claims[i].right ? 1 : 0;
    if (i + 1 < claims.size() && claims[i + 1].score == claims[i].score) continue;
    const auto made = static_cast<std::int64_t>(i + 1);
    curve.push_back(
        {claims[i].score, made, static_cast<double>(right) / static_cast<double>(made),
         findable > 0 ? static_cast<double>(right) / static_cast<double>(findable) : 0});
  }
  return curve;
}

double recallAt(const std::vector<PrecisionRecall>& curve, double precision) {
  double recall = 0;
  for (const PrecisionRecall& point : curve) {
    if (point.precision >= precision) recall = std::max(recall, point.recall);
  }
  return recall;
}

}  // namespace tolman::evaluation
