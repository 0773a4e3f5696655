// SPDX-License-Identifier: BSD-3-Clause
// Waking up somewhere: path integration cannot judge views of a part of the path that nothing joins
// with the present one. So views judge each other: right ones agree on where the robot is.
#pragma once

#include <cstddef>
#include <deque>

#include "path_memory.hpp"
#include "view_evidence.hpp"

namespace tolman::bayesian_attractor {

struct RelocationSettings {
  int views = 3;         ///< that must agree
  double spacing = 5;    ///< m between them: look-alikes, too, come in runs
  double gate = 16;      ///< chi-square of three degrees of freedom up to which two agree
  double decisive = 20;  ///< odds for that agreement against chance
};

class Relocation {
 public:
  explicit Relocation(const RelocationSettings& settings) : settings_(settings) {}

  /// What one view says: the robot is at `seen` from where it once learned the view.
  struct Claim {
    PathMark learned;
    PathMark here;
    UncertainStep seen;
  };

  /// Takes up a view that is being seen now. True when enough views agree with it: the robot knows
  /// where it is, and the claims are forgotten.
  bool agrees(const PathMemory& memory, const ViewEvidence& evidence, const PathMark& learned,
              const UncertainStep& seen);
  void forget() { claims_.clear(); }

  const std::deque<Claim>& claims() const { return claims_; }
  void restore(std::deque<Claim> claims) { claims_ = std::move(claims); }

 private:
  bool supports(const Claim& claim, const PathMemory& memory, const ViewEvidence& evidence,
                const PathMark& learned, const UncertainStep& seen) const;

  RelocationSettings settings_;
  std::deque<Claim> claims_;  ///< the latest ones, all of the present part
};

}  // namespace tolman::bayesian_attractor
