// SPDX-License-Identifier: BSD-3-Clause
// Minimises the energy of graph_optimiser with Ceres, as in the paper: with a manifold for the
// angle (in space: for the unit quaternion), Ceres' loss functions, and sparse Cholesky.
#pragma once

#include "graph_optimiser.hpp"

namespace tolman::experience_map {

/// See optimise(). Starts with the weights that the loss gives at `nodes`, not with those of
/// `links`.
template <class G>
Result<OptimiserOutcome> optimiseWithCeres(const OptimiserOptions& options,
                                           std::vector<typename G::Pose>& nodes,
                                           std::vector<PoseLink<G>>& links);

}  // namespace tolman::experience_map
