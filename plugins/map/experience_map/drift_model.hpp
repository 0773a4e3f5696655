// SPDX-License-Identifier: BSD-3-Clause
// Estimates the drift of odometry in space from closed loops. An error of height between two visits
// may come from a steady drift of position or from an error of rotation, and the two give different
// maps. They are distinguished by the orientations that the loops measure.
#pragma once

#include <vector>

#include "chain_system.hpp"
#include "spatial_link.hpp"

namespace tolman::experience_map {

struct DriftModel {
  double rotation = 0;  ///< rad/m: standard deviation of the rotation of a link, per metre
  Eigen::Vector3d steady = Eigen::Vector3d::Zero();  ///< m per m driven, axes of the camera
};

struct DriftPrior {
  double rotation = 0;  ///< rad/m: the largest value, at which the prior has its maximum
  double steady = 0;    ///< m per m: standard deviation of each component of the steady drift
};

/// Returns an odometry link over `length` m, whose covariance contains a drift of `rotation` rad/m,
/// with this drift replaced by `drift`.
SpatialLink withDrift(SpatialLink link, double length, double rotation, const DriftModel& drift);

/// Empirical Bayes. Returns the drift of rotation with the largest posterior probability among
/// prior.rotation, a quarter and a sixteenth of it, and the most probable steady drift. Poses and
/// steady drift are marginalised to second order around `nodes`. `links` are first an odometry link
/// to each node from the one before, under prior.rotation, over `lengths` m (0: motion unknown),
/// then the loops, whose weights are kept. `system` is working memory.
DriftModel learnDrift(const std::vector<Eigen::Isometry3d>& nodes,
                      const std::vector<SpatialLink>& links, const std::vector<double>& lengths,
                      const DriftPrior& prior, ChainSystem<Space>& system);

}  // namespace tolman::experience_map
