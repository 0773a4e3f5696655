// SPDX-License-Identifier: BSD-3-Clause
// Bayes' rule for one familiar view: is it the place that it looks like, or a look-alike anywhere
// in the explored world? Path integration is the witness.
#pragma once

#include <cstdint>

#include "path_memory.hpp"

namespace tolman::bayesian_attractor {

struct EvidenceSettings {
  double prior = 0.05;       ///< share of familiar views that are right, before any was seen
  double prior_views = 100;  ///< so many views weigh as much as that expectation
  double gate = 16;          ///< chi-square of three degrees of freedom; 16 is 99.9 %
  double decisive = 20;      ///< odds at which a view with a measured pose decides alone
  double margin = 20;        ///< m around the path that count as explored
};

enum class Verdict : std::uint8_t {
  RuledOut,   ///< path integration knows better
  Plausible,  ///< needs others beside it
  Decisive,   ///< a look-alike would hardly lie just there
};

class ViewEvidence {
 public:
  explicit ViewEvidence(const EvidenceSettings& settings) : settings_(settings) {}

  /// Odds that a view is right which puts the robot at `seen`, as against `predicted`; both are
  /// seen from where the view was learned.
  double odds(const UncertainStep& predicted, const UncertainStep& seen, double area) const;
  /// Judges a view, and counts it.
  Verdict judge(const PathMemory& memory, const PathMark& learned, const UncertainStep& seen);
  /// Counts one that was judged by others.
  void count() { ++counts_.views; }
  /// The network decided for so many views: they were right.
  void confirm(std::int64_t views) { counts_.right += views; }
  /// Expected share of right ones among familiar views (mean of a beta distribution).
  double prior() const;

  double margin() const { return settings_.margin; }

  /// All that decides the future, for saving.
  struct Counts {
    std::int64_t views = 0;  ///< judged
    std::int64_t right = 0;  ///< of these, as far as the network knows
  };
  const Counts& counts() const { return counts_; }
  void restore(const Counts& counts) { counts_ = counts; }

 private:
  Verdict weigh(const PathMemory& memory, const PathMark& learned, const UncertainStep& seen) const;

  EvidenceSettings settings_;
  Counts counts_;
};

}  // namespace tolman::bayesian_attractor
