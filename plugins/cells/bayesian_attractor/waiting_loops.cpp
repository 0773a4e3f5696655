// SPDX-License-Identifier: BSD-3-Clause
#include "waiting_loops.hpp"

#include <algorithm>

namespace tolman::bayesian_attractor {

void WaitingLoops::add(const WaitingLoop& loop) {
  for (const WaitingLoop& other : loops_) {
    if (other.bump == loop.bump && loop.travel - other.travel < spacing_) return;
  }
  loops_.push_back(loop);
}

void WaitingLoops::keep(std::span<const CalibrationBump> bumps) {
  std::erase_if(loops_, [&](const WaitingLoop& loop) {
    return std::ranges::find(bumps, loop.bump, &CalibrationBump::id) == bumps.end();
  });
}

std::vector<EarlierLoop> WaitingLoops::of(std::int64_t bump, double travel) const {
  std::vector<EarlierLoop> loops;
  for (const WaitingLoop& waiting : loops_) {
    if (waiting.bump == bump && travel - waiting.travel >= spacing_) loops.push_back(waiting.loop);
  }
  return loops;
}

}  // namespace tolman::bayesian_attractor
