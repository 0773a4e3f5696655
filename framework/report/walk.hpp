// SPDX-License-Identifier: BSD-3-Clause
// The way through the finished map, and how strongly the units of a population fired along it.
#pragma once

#include <cstddef>
#include <vector>

#include "evaluation/trajectory.hpp"
#include "report/cell_history.hpp"
#include "report/firing_rate.hpp"

namespace tolman::report {

class Walk {
 public:
  /// At the frames of `population`, which must outlive the walk. Frames that the map has no pose
  /// of, or one that has run away, are left out.
  Walk(const PopulationHistory& population, const evaluation::Trajectory& map);

  /// The visits in the order of time with the rate of one unit, counted from 0. `shift`, a share of
  /// the way, takes the rate of a later moment: such a unit knows nothing of the place.
  std::vector<Sample> samples(std::size_t unit, double shift = 0) const;
  /// In bins that steps do not jump over, or every visit would be a field of its own.
  RateMap rates(std::size_t unit, double shift = 0) const;

 private:
  std::vector<Sample> way_;  ///< without rates
  std::vector<const std::vector<float>*> activity_;
  int bins_ = 1;  ///< on the long side
};

}  // namespace tolman::report
