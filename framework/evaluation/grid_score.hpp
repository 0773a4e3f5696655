// SPDX-License-Identifier: BSD-3-Clause
// Grid scores: how well the autocorrelogram of a rate map agrees with itself when it is rotated.
//
// The autocorrelogram holds, for each displacement, the correlation of the map with itself over the
// bins that both copies have visited. A ring of it, without the central peak, is rotated; r(a) is
// its correlation with itself after the angle a. It has two-fold symmetry, so r(120) = r(60),
// r(150) = r(30), and r(135) = r(45).
#pragma once

#include <Eigen/Core>
#include <optional>

#include "evaluation/firing_rate.hpp"

namespace tolman::evaluation {

/// Correlation by displacement in bins, (0, 0) in the middle; NaN where too few bins overlap.
Eigen::MatrixXd autocorrelogram(const RateMap& map, int reach);

struct GridScores {
  /// r(60) - max(r(30), r(90)) of the ring of the nearest peaks: min(60, 120) - max(30, 90, 150) of
  /// Sargolini et al., "Conjunctive representation of position, direction, and velocity in
  /// entorhinal cortex", Science 312, 2006. About 1 and more for a hexagonal lattice.
  double sargolini = 0;
  /// The largest such score of all rings from the central peak to a growing radius: Langston et
  /// al., "Development of the spatial representation system in the rat", Science 328, 2010.
  double langston = 0;
  /// r(90) - r(45) of the ring of the nearest peaks: about 1 and more for a square lattice.
  double square = 0;
  double spacing = 0;  ///< m, distance of the nearest peaks
};

/// None if the map is too narrow for neighbouring fields, or if the rate is the same everywhere.
std::optional<GridScores> gridScores(const RateMap& map);

}  // namespace tolman::evaluation
