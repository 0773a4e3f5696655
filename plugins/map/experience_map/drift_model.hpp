// SPDX-License-Identifier: BSD-3-Clause
// Estimates the drift of odometry in space from closed loops. An error of height between two visits
// may come from a steady drift of position or from an error of rotation. The two give different
// maps; the orientations that the loops measure distinguish them.
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
  double steady = 0;    ///< standard deviation of each component of the steady drift
};

/// Converts an odometry link over `length` m, whose covariance contains a drift of `rotation`
/// rad/m, to the drift `drift`.
SpatialLink withDrift(SpatialLink link, double length, double rotation, const DriftModel& drift);

/// Empirical Bayes: of prior.rotation, a quarter and a sixteenth of it, the drift of rotation with
/// the largest posterior probability, and the most likely steady drift. Poses and steady drift are
/// marginalised to second order around `nodes`. `links`: first an odometry link to each node from
/// the one before, under prior.rotation, over `lengths` m (0: motion unknown), then loops, whose
/// weights are kept. `system` is working memory.
DriftModel learnDrift(const std::vector<Eigen::Isometry3d>& nodes,
                      const std::vector<SpatialLink>& links, const std::vector<double>& lengths,
                      const DriftPrior& prior, ChainSystem<Space>& system);

}  // namespace tolman::experience_map
