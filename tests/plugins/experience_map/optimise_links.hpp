// SPDX-License-Identifier: BSD-3-Clause
// The optimiser for nodes and links without steady errors of odometry.
#pragma once

#include "graph_optimiser.hpp"

namespace tolman::experience_map {

template <class Pose, class G>
Result<OptimiserOutcome> optimise(const OptimiserOptions& options, std::vector<Pose>& nodes,
                                  std::vector<PoseLink<G>>& links) {
  PoseGraph<G> graph{nodes, links};
  BorderedSystem<G> system;
  const Result<OptimiserOutcome> outcome = optimise<G>(options, graph, system);
  nodes = graph.nodes;
  links = graph.links;
  return outcome;
}

template <class Pose, class G>
Result<OptimiserOutcome> optimiseMultiStart(const OptimiserOptions& options,
                                            const std::vector<Pose>& reckoned,
                                            std::vector<Pose>& nodes,
                                            std::vector<PoseLink<G>>& links) {
  PoseGraph<G> graph{nodes, links};
  BorderedSystem<G> system;
  const Result<OptimiserOutcome> outcome = optimiseMultiStart<G>(options, reckoned, graph, system);
  nodes = graph.nodes;
  links = graph.links;
  return outcome;
}

}  // namespace tolman::experience_map
