// SPDX-License-Identifier: BSD-3-Clause
// The same minimum as optimise(), found by Ceres, as in the paper: parameter blocks on the manifold
// of angles, losses of Ceres's own kind, sparse Cholesky.
#pragma once

#include "planar_optimiser.hpp"

namespace tolman::experience_map {

/// See optimise(). Always starts with the weights that the loss gives at `nodes`.
Result<Outcome> optimiseWithCeres(const OptimiserOptions& options, std::vector<PlanarPose>& nodes,
                                  std::vector<PlanarLink>& links);

}  // namespace tolman::experience_map
