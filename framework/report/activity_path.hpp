// SPDX-License-Identifier: BSD-3-Clause
// The path in the finished map with the activity of each unit of a population along it: the samples
// from which firing rate maps and tuning curves are made.
#pragma once

#include <cstddef>
#include <vector>

#include "evaluation/firing_rate.hpp"
#include "evaluation/trajectory.hpp"
#include "report/cell_history.hpp"

namespace tolman::report {

using evaluation::fields;
using evaluation::highestRate;
using evaluation::kDegrees;
using evaluation::RateMap;
using evaluation::rateMap;
using evaluation::Sample;
using evaluation::spatialInformation;
using evaluation::TuningCurve;
using evaluation::tuningCurve;

class ActivityPath {
 public:
  /// At the frames of `population`, which must outlive this. Frames without a pose in the map, or
  /// with one farther away than 10,000 km, are left out.
  ActivityPath(const PopulationHistory& population, const evaluation::Trajectory& map);

  /// Samples of one unit (from 0) in the order of time. `shift`, a share of the path, pairs each
  /// position with the rate of a later frame: the rate is then independent of the position.
  std::vector<Sample> samples(std::size_t unit, double shift = 0) const;
  /// The bins are wider than the steps between frames; otherwise each visit would be its own field.
  RateMap rates(std::size_t unit, double shift = 0) const;

 private:
  std::vector<Sample> way_;  ///< without rates
  std::vector<const std::vector<float>*> activity_;
  int bins_ = 1;  ///< on the long side
};

}  // namespace tolman::report
