// SPDX-License-Identifier: BSD-3-Clause
// Minimises the energy of graph_optimiser with Ceres, as the paper does: parameter blocks on the
// manifold of angles (in space: of unit quaternions), Ceres loss functions, sparse Cholesky.
#pragma once

#include "graph_optimiser.hpp"

namespace tolman::experience_map {

/// See optimise(). The initial weights are not used, but those that the loss gives at `nodes`.
template <class G>
Result<OptimiserOutcome> optimiseWithCeres(const OptimiserOptions& options,
                                           std::vector<typename G::Pose>& nodes,
                                           std::vector<PoseLink<G>>& links);

}  // namespace tolman::experience_map
