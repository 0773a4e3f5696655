// SPDX-License-Identifier: BSD-3-Clause
// Absolute and relative errors of an aligned estimate (Sturm et al., "A benchmark for the
// evaluation of RGB-D SLAM systems", IROS 2012).
#pragma once

#include <vector>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

struct Statistics {
  std::size_t count = 0;
  double rmse = 0;
  double mean = 0;
  double median = 0;  ///< of an even count: the mean of the middle two
  double min = 0;
  double max = 0;
};

/// All 0 for no values.
Statistics statistics(std::vector<double> values);

/// Distances between matched positions, m. `planar` leaves height (camera y) out, for an estimate
/// without height.
std::vector<double> positionErrors(const Matches& aligned, bool planar = false);
/// Statistics of positionErrors().
Statistics absoluteError(const Matches& aligned, bool planar = false);

/// The error of motion over a step: |T_truth^-1 T_estimate| of matched motions.
struct RelativeError {
  Statistics translation_m;
  Statistics rotation_deg;
};

/// Over steps of `delta` frames (by the estimate's frame indices; missing frames give no pair).
RelativeError relativeErrorOverFrames(const Matches& aligned, std::int64_t delta = 1);

/// Over steps of at least `length` metres of the true path, one from each pose; errors are divided
/// by the length of the step and so are per metre.
RelativeError relativeErrorOverDistance(const Matches& aligned, double length = 1);

}  // namespace tolman::evaluation
