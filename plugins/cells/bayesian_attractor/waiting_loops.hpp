// SPDX-License-Identifier: BSD-3-Clause
// Loops of views whose calibration bump is not accepted yet.
//
// A bump is accepted after several views were injected into it; each of these views saw a known
// place. Their loops are kept here, at most one per `spacing` metres and bump, until the bump is
// accepted or removed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bump_network.hpp"
#include "tolman/records.hpp"

namespace tolman::bayesian_attractor {

struct WaitingLoop {
  std::int64_t bump = -1;  ///< CalibrationBump::id
  double travel = 0;       ///< m driven until the view
  EarlierLoop loop;
};

class WaitingLoops {
 public:
  explicit WaitingLoops(double spacing) : spacing_(spacing) {}

  void add(const WaitingLoop& loop);
  /// Removes the loops of all bumps that are not among `bumps`.
  void keep(std::span<const CalibrationBump> bumps);
  /// Loops of the bump that are at least `spacing` before `travel`, in the order of their frames.
  std::vector<EarlierLoop> of(std::int64_t bump, double travel) const;

  const std::vector<WaitingLoop>& list() const { return loops_; }
  void restore(std::vector<WaitingLoop> loops) { loops_ = std::move(loops); }

 private:
  double spacing_;
  std::vector<WaitingLoop> loops_;  ///< in the order of their frames
};

}  // namespace tolman::bayesian_attractor
