// SPDX-License-Identifier: BSD-3-Clause
// Absolute and relative errors of an aligned estimate (Sturm et al., "A benchmark for the
// evaluation of RGB-D SLAM systems", IROS 2012).
#pragma once

#include <cstdint>
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

/// The parts of a distance. Vertical is along the y axis of the truth's world frame; horizontal
/// is in its x-z plane. scoreTrajectory() makes that world the first true camera.
enum class Direction : std::uint8_t { All, Horizontal, Vertical };

/// Distances between matched positions, m.
std::vector<double> positionErrors(const Matches& aligned, Direction direction = Direction::All);
/// Statistics of positionErrors().
Statistics absoluteError(const Matches& aligned, Direction direction = Direction::All);

/// The error of motion over a step: |T_truth^-1 T_estimate| of matched motions.
struct RelativeError {
  Statistics translation_m;
  Statistics rotation_deg;
};

/// Over steps of `delta` frames (by the estimate's frame indices; missing frames give no pair, and
/// neither does the step from one session to the next).
RelativeError relativeErrorOverFrames(const Matches& aligned, std::int64_t delta = 1);

/// Over steps of at least `length` metres of the true path, one from each pose, within one
/// session; errors are divided by the length of the step and so are per metre.
RelativeError relativeErrorOverDistance(const Matches& aligned, double length = 1);

}  // namespace tolman::evaluation
