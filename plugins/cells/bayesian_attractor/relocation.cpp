// SPDX-License-Identifier: BSD-3-Clause
#include "relocation.hpp"

#include <cmath>

namespace tolman::bayesian_attractor {
namespace {

constexpr std::size_t kClaimsRemembered = 200;

}  // namespace

/// Were `claim` right, the robot would be at over(claim). Both views must be right for that: hence
/// the prior once more.
bool Relocation::supports(const Claim& claim, const PathMemory& memory,
                          const ViewEvidence& evidence, const PathMark& learned,
                          const UncertainStep& seen) const {
  if (claim.learned.part != learned.part || claim.here.part != memory.now().part) return false;
  const UncertainStep expected = memory.over({claim.learned, claim.here, claim.seen}, learned);
  if (chiSquare(expected, seen) > settings_.gate) return false;
  const double odds = evidence.odds(expected, seen, memory.exploredArea(evidence.margin()));
  return odds * evidence.prior() >= settings_.decisive;
}

bool Relocation::agrees(const PathMemory& memory, const ViewEvidence& evidence,
                        const PathMark& learned, const UncertainStep& seen) {
  int views = 1;
  double travelled = memory.now().lengths(0);
  for (auto claim = claims_.rbegin(); claim != claims_.rend(); ++claim) {
    if (travelled - claim->here.lengths(0) < settings_.spacing) continue;
    if (!supports(*claim, memory, evidence, learned, seen)) continue;
    travelled = claim->here.lengths(0);
    ++views;
  }
  claims_.push_back({learned, memory.now(), seen});
  if (claims_.size() > kClaimsRemembered) claims_.pop_front();
  if (views < settings_.views) return false;
  claims_.clear();
  return true;
}

}  // namespace tolman::bayesian_attractor
