// SPDX-License-Identifier: BSD-3-Clause
// The paper's energy over all nodes and links of the plane, and losses that let false links go.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <tolman/geometry.hpp>
#include <tolman/status.hpp>
#include <vector>

#include "planar_link.hpp"

namespace tolman::experience_map {

/// With r the length of a residual in standard deviations:
enum class Loss : std::uint8_t {
  Huber,         ///< convex; a false link keeps pulling with constant force (the paper's)
  GemanMcclure,  ///< redescending; a link that contradicts the others lets go
};
inline constexpr std::array<std::string_view, 2> kLossNames = {"huber", "geman_mcclure"};
constexpr std::span<const std::string_view> enumNames(Loss) { return kLossNames; }

enum class Solver : std::uint8_t {
  Elimination,  ///< our own, which knows that the graph is a chain with loops (chain_system)
  Ceres,        ///< the paper's, which knows any graph
};
inline constexpr std::array<std::string_view, 2> kSolverNames = {"elimination", "ceres"};
constexpr std::span<const std::string_view> enumNames(Solver) { return kSolverNames; }

struct OptimiserOptions {
  Solver solver = Solver::Elimination;
  int iterations = 100;
  Loss loss = Loss::Huber;
  double delta = 1;          ///< Huber: r up to which the loss is quadratic; Geman-McClure: c
  bool annealed = false;     ///< Geman-McClure: forget the weights and go from convex to sharp
  double tolerance = 1e-10;  ///< relative change of the energy that ends the search
  /// Another way has led to this energy: a search that at its pace will not come below is given up.
  double rival = std::numeric_limits<double>::infinity();
};

struct Outcome {
  bool converged = false;
  double energy = 0;  ///< sum of rho
};

/// min over e of 1/2 sum rho(|f(e_i, e_j, e_ij)|^2), node 0 held, by damped Gauss-Newton with
/// weights from the loss. Improves `nodes` from where they are, and the weights from what they are
/// (new links: 1, "believed at first"); leaves both alone when it fails.
Result<Outcome> optimise(const OptimiserOptions& options, std::vector<PlanarPose>& nodes,
                         std::vector<PlanarLink>& links);

/// The same with all the care that a redescending loss needs, which has many minima: the best of
/// three ways, from `nodes` as they are, annealed, and from dead reckoning with no loop believed,
/// below which no map may fall.
Result<Outcome> judge(OptimiserOptions options, const std::vector<PlanarPose>& reckoned,
                      std::vector<PlanarPose>& nodes, std::vector<PlanarLink>& links);

}  // namespace tolman::experience_map
