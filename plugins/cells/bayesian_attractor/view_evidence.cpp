// SPDX-License-Identifier: BSD-3-Clause
#include "view_evidence.hpp"

#include <cmath>
#include <numbers>

namespace tolman::bayesian_attractor {

double ViewEvidence::odds(const UncertainStep& predicted, const UncertainStep& seen,
                          double area) const {
  constexpr double kTurn = 2 * std::numbers::pi;
  const Eigen::Matrix3d covariance = predicted.covariance + seen.covariance;
  const double if_right = std::exp(-0.5 * chiSquare(predicted, seen)) /
                          std::sqrt(kTurn * kTurn * kTurn * covariance.determinant());
  const double if_wrong = 1 / (area * kTurn);  // anywhere, facing anywhere
  return prior() / (1 - prior()) * if_right / if_wrong;
}

double ViewEvidence::prior() const {
  return (settings_.prior * settings_.prior_views + static_cast<double>(counts_.right)) /
         (settings_.prior_views + static_cast<double>(counts_.views));
}

Verdict ViewEvidence::judge(const PathMemory& memory, const PathMark& learned,
                            const UncertainStep& seen) {
  const Verdict verdict = weigh(memory, learned, seen);
  ++counts_.views;
  return verdict;
}

Verdict ViewEvidence::weigh(const PathMemory& memory, const PathMark& learned,
                            const UncertainStep& seen) const {
  const UncertainStep predicted = memory.predict(learned);
  if (chiSquare(predicted, seen) <= settings_.gate) {
    const double ratio = odds(predicted, seen, memory.exploredArea(settings_.margin));
    return ratio >= settings_.decisive ? Verdict::Decisive : Verdict::Plausible;
  }
  // A closed loop may itself be false: what dead reckoning alone allows gets a chance, not more.
  if (learned.part != memory.now().part) return Verdict::RuledOut;
  const UncertainStep reckoned = memory.between(learned, memory.now());
  return chiSquare(reckoned, seen) <= settings_.gate ? Verdict::Plausible : Verdict::RuledOut;
}

}  // namespace tolman::bayesian_attractor
