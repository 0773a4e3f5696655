// SPDX-License-Identifier: BSD-3-Clause
// Minimises the energy of planar_optimiser with Ceres, as the paper does: parameter blocks on the
// manifold of angles, Ceres loss functions, sparse Cholesky.
#pragma once

#include "planar_optimiser.hpp"

namespace tolman::experience_map {

/// See optimise(). The initial weights are not used, but those that the loss gives at `nodes`.
Result<OptimiserOutcome> optimiseWithCeres(const OptimiserOptions& options,
                                           std::vector<PlanarPose>& nodes,
                                           std::vector<PlanarLink>& links);

}  // namespace tolman::experience_map
