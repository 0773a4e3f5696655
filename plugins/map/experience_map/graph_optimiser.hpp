// SPDX-License-Identifier: BSD-3-Clause
// Minimises the energy of the paper's section "Cognitive Map" over poses e_i, in the plane or in
// space,
//
//   min over e of 1/2 sum_k rho(|f_k|),    f_k: residual of link k in standard deviations,
//
// with a robust loss rho, by iteratively reweighted Gauss-Newton steps. With the Geman-McClure loss
// they include a part of the curvature of rho.
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

#include "bordered_system.hpp"

namespace tolman::experience_map {

/// Initial weight of a loop that shall not influence the first step. Chosen, not tuned.
inline constexpr double kRejectedWeight = 1e-6;

/// rho as a function of r, the length of a residual in standard deviations.
enum class Loss : std::uint8_t {
  Huber,         ///< convex, the paper's: quadratic up to delta, linear beyond
  GemanMcclure,  ///< redescending: c^2 r^2 / (c^2 + r^2), bounded for false links
};
inline constexpr std::array<std::string_view, 2> kLossNames = {"huber", "geman_mcclure"};
constexpr std::span<const std::string_view> enumNames(Loss) { return kLossNames; }

struct OptimiserOptions {
  int iterations = 100;  ///< largest number; see kFinalIterations
  Loss loss = Loss::Huber;
  double delta = 1;          ///< Huber: r up to which the loss is quadratic; Geman-McClure: c
  bool annealed = false;     ///< Geman-McClure: graduated non-convexity from weights of 1
  double tolerance = 1e-10;  ///< relative change of the energy that ends the iterations
  /// Stops when the energy, at its present rate of decrease, cannot reach this bound within the
  /// remaining iterations.
  double energy_bound = std::numeric_limits<double>::infinity();
};

struct OptimiserOutcome {
  bool converged = false;
  double energy = 0;  ///< sum of rho
};

/// Minimises the energy from the given nodes, errors and weights (1 for new links); node 0 is
/// fixed. On failure nothing changes. `system` is working memory, which several calls share.
template <class G>
Result<OptimiserOutcome> optimise(const OptimiserOptions& options, PoseGraph<G>& graph,
                                  BorderedSystem<G>& system);

/// A redescending loss has many local minima. Optimises from the graph as given; if that does not
/// converge, or gives a loop a weight of 0.5 or less, also by graduated non-convexity and from dead
/// reckoning without loops, and keeps the result of least energy. With Huber's loss, which is
/// convex, only from there.
template <class G>
Result<OptimiserOutcome> optimiseMultiStart(OptimiserOptions options,
                                            const std::vector<typename G::Pose>& reckoned,
                                            PoseGraph<G>& graph, BorderedSystem<G>& system);

}  // namespace tolman::experience_map
