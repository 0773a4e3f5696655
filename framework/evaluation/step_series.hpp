// SPDX-License-Identifier: BSD-3-Clause
// True and estimated motion over the same short stretches of a path: one curve that shows where a
// trajectory is broken. A report draws it.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// Motions from pair `first` to pair `last`, each in the axes of its own body.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
  Eigen::Isometry3d truth;
  Eigen::Isometry3d estimate;
};

Stretch stretchBetween(const Matches& matches, std::size_t first, std::size_t last);

/// Consecutive stretches of `steps` pairs that are tracked throughout, within one piece of the
/// path.
std::vector<Stretch> stretches(const Matches& matches, std::size_t steps);

/// By stretch: how the estimated motion differs from the true one.
struct StepSeries {
  std::vector<Stretch> stretches;
  std::vector<std::int64_t> frames;  ///< of the true pose at the end
  std::vector<double> log_ratio;     ///< natural logarithm of estimated over true length
  std::vector<double> turn;          ///< angle between the two rotations, rad
};
/// A tenth of the usual true length is added to both lengths, so that noise at a standstill is no
/// ratio.
StepSeries stepSeries(const Matches& matches, std::size_t steps);

/// What breaks the curve: a truth or an estimate that stands still while the other moves, a jump or
/// a turn of the truth in a single step, an estimate that starts again at its origin, a change of
/// units. One sentence each, with the frames; nothing for a curve without outliers, whatever its
/// noise.
std::vector<std::string> breaksOf(const Matches& matches);

/// The pairs at which the estimate starts again at its origin, as after a loss of tracking.
std::vector<std::size_t> restartsOf(const Matches& matches);

}  // namespace tolman::evaluation
