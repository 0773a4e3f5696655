// SPDX-License-Identifier: BSD-3-Clause
// Iteratively reweighted Gauss-Newton. Graduated non-convexity: Yang, Antonante, Tzoumas, Carlone,
// "Graduated Non-Convexity for Robust Spatial Perception", RA-L 2020, with the Geman-McClure loss.
#include "graph_optimiser.hpp"

#include <algorithm>
#include <cmath>

#include "ceres_optimiser.hpp"
#include "chain_system.hpp"
#include "planar_link.hpp"
#include "spatial_link.hpp"

namespace tolman::experience_map {
namespace {

constexpr double kAcceptedWeight = 0.5;  ///< with all weights above it, other starts are not tried

template <class G>
class GaussNewton {
 public:
  using Pose = typename G::Pose;
  using PoseLinks = std::vector<PoseLink<G>>;

  GaussNewton(const OptimiserOptions& options, std::vector<Pose>& nodes, PoseLinks& links)
      : options_(options), nodes_(nodes), links_(links), system_(nodes.size(), links) {
    for (const PoseLink<G>& link : links) information_.push_back(informationOf(link.covariance));
    chi_square_.resize(links.size());
    measure();
  }

  /// Graduated non-convexity: mu falls from a convex loss to 1, the Geman-McClure loss itself.
  Result<bool> anneal() {
    for (PoseLink<G>& link : links_) link.weight = 1;
    if (Status rough = descendRoughly(); !rough.isOk()) return rough;
    double worst = 0;
    for (std::size_t k = 0; k < links_.size(); ++k) {
      if (links_[k].robust) worst = std::max(worst, chi_square_[k]);
    }
    constexpr double kEase = 1.4;  // factor of mu, as in the paper by Yang et al.
    for (double mu = 2 * worst / (options_.delta * options_.delta); mu > 1; mu /= kEase) {
      reweigh(mu);
      if (Status taken = step(); !taken.isOk()) return taken;
    }
    return descend();
  }

  /// Steps until the energy converges or the iterations are used up. Returns whether it converged.
  Result<bool> descend() {
    double before = energy();
    for (int iteration = 0; iteration < options_.iterations; ++iteration) {
      if (iteration > 0) reweigh(1);
      if (Status taken = step(); !taken.isOk()) return taken;
      const double after = energy();
      if (std::abs(before - after) <= options_.tolerance * before) {
        reweigh(1);
        return true;
      }
      if (cannotReachBound(iteration, before - after, after)) break;
      before = after;
    }
    reweigh(1);
    return false;
  }

  /// sum of rho; does not depend on the weights.
  double energy() const {
    const double bound = options_.delta * options_.delta;
    double sum = 0;
    for (std::size_t k = 0; k < links_.size(); ++k) {
      const double chi = chi_square_[k];
      if (!links_[k].robust) {
        sum += chi;
      } else if (options_.loss == Loss::GemanMcclure) {
        sum += bound * chi / (bound + chi);
      } else {
        sum += chi <= bound ? chi : 2 * options_.delta * std::sqrt(chi) - bound;
      }
    }
    return sum;
  }

 private:
  /// Approximate least squares over all links: the start of graduated non-convexity.
  Status descendRoughly() {
    constexpr int kSteps = 20;
    constexpr double kRest = 0.01;
    double before = leastSquares();
    for (int i = 0; i < kSteps; ++i) {
      if (Status taken = step(); !taken.isOk()) return taken;
      const double after = leastSquares();
      if (before - after <= kRest * before) break;
      before = after;
    }
    return Status::ok();
  }

  /// Squared residuals of all links at the present nodes.
  void measure() {
    for (std::size_t k = 0; k < links_.size(); ++k) {
      const PoseLink<G>& link = links_[k];
      const StepOf<G> error = residualOf(link, nodes_[link.from], nodes_[link.to]);
      chi_square_[k] = error.dot(information_[k] * error);
    }
  }

  bool cannotReachBound(int iteration, double gain, double energy) const {
    constexpr int kPatience = 10;  // iterations before the rate of decrease is meaningful
    const int left = options_.iterations - iteration - 1;
    return iteration >= kPatience && energy - left * gain > options_.energy_bound;
  }

  void reweigh(double mu) {
    const double delta = options_.delta;
    for (std::size_t k = 0; k < links_.size(); ++k) {
      if (!links_[k].robust) continue;
      const double chi = chi_square_[k];
      if (options_.loss == Loss::Huber) {
        links_[k].weight = std::min(1.0, delta / std::max(std::sqrt(chi), 1e-300));
      } else {
        const double root = mu * delta * delta / (mu * delta * delta + chi);
        links_[k].weight = root * root;
      }
    }
  }

  /// Weighted sum of squared residuals.
  double leastSquares() const {
    double sum = 0;
    for (std::size_t k = 0; k < links_.size(); ++k) sum += links_[k].weight * chi_square_[k];
    return sum;
  }

  /// One Levenberg-Marquardt step with fixed weights.
  Status step() {
    constexpr double kLeastDamping = 1e-4;
    constexpr double kMostDamping = 1e8;
    const std::vector<Pose> start = nodes_;
    const double before = leastSquares();
    system_.linearise(nodes_, links_);
    for (double damping = damping_; damping < kMostDamping;
         damping = std::max(kLeastDamping, 10 * damping)) {
      if (!system_.solve(damping, step_)) continue;
      for (std::size_t k = 0; k < nodes_.size(); ++k) nodes_[k] = moved(start[k], step_[k]);
      measure();
      if (leastSquares() <= before * (1 + 1e-12) + 1e-300) {
        damping_ = damping > kLeastDamping ? 0.1 * damping : 0;
        return Status::ok();
      }
    }
    nodes_ = start;  // at a minimum, up to rounding
    measure();
    if (before == 0 || system_.solve(0, step_)) return Status::ok();
    return Status::failed("the normal equations of the map are singular");
  }

  OptimiserOptions options_;
  std::vector<Pose>& nodes_;
  PoseLinks& links_;
  ChainSystem<G> system_;
  std::vector<MatrixOf<G>> information_;
  std::vector<double> chi_square_;  ///< of each link
  std::vector<StepOf<G>> step_;
  double damping_ = 0;
};

}  // namespace

template <class G>
Result<OptimiserOutcome> optimise(const OptimiserOptions& options,
                                  std::vector<typename G::Pose>& nodes,
                                  std::vector<PoseLink<G>>& links) {
  if (options.solver == Solver::Ceres) return optimiseWithCeres<G>(options, nodes, links);
  std::vector<typename G::Pose> improved = nodes;
  std::vector<PoseLink<G>> weighed = links;
  GaussNewton<G> descent(options, improved, weighed);
  const bool annealed = options.annealed && options.loss == Loss::GemanMcclure;
  const Result<bool> converged = annealed ? descent.anneal() : descent.descend();
  if (!converged.isOk()) return converged.status();
  const OptimiserOutcome outcome = {converged.value(), descent.energy()};
  nodes = std::move(improved);
  links = std::move(weighed);
  return outcome;
}

template <class G>
Result<OptimiserOutcome> optimiseMultiStart(OptimiserOptions options,
                                            const std::vector<typename G::Pose>& reckoned,
                                            std::vector<typename G::Pose>& nodes,
                                            std::vector<PoseLink<G>>& links) {
  using Poses = std::vector<typename G::Pose>;
  using PoseLinks = std::vector<PoseLink<G>>;
  const Poses start = nodes;
  const PoseLinks initial_links = links;
  Result<OptimiserOutcome> best = optimise<G>(options, nodes, links);
  if (options.loss == Loss::Huber) return best;  // convex: no other starts are needed
  const bool all_accepted = std::ranges::all_of(
      links, [](const PoseLink<G>& link) { return link.weight > kAcceptedWeight; });
  if (best.isOk() && best.value().converged && all_accepted) return best;
  const auto attempt = [&](Poses from, PoseLinks weighted) {
    if (best.isOk()) options.energy_bound = best.value().energy;
    const Result<OptimiserOutcome> outcome = optimise<G>(options, from, weighted);
    if (!outcome.isOk()) return;
    if (best.isOk() && best.value().energy <= outcome.value().energy) return;
    best = outcome;
    nodes = std::move(from);
    links = std::move(weighted);
  };
  options.annealed = true;
  attempt(start, initial_links);
  options.annealed = false;
  PoseLinks without_loops = initial_links;
  for (PoseLink<G>& link : without_loops) link.weight = link.robust ? kRejectedWeight : 1;
  attempt(reckoned, std::move(without_loops));
  return best;
}

template Result<OptimiserOutcome> optimise<Plane>(const OptimiserOptions&,
                                                  std::vector<Plane::Pose>&,
                                                  std::vector<PoseLink<Plane>>&);
template Result<OptimiserOutcome> optimiseMultiStart<Plane>(OptimiserOptions,
                                                            const std::vector<Plane::Pose>&,
                                                            std::vector<Plane::Pose>&,
                                                            std::vector<PoseLink<Plane>>&);
template Result<OptimiserOutcome> optimise<Space>(const OptimiserOptions&,
                                                  std::vector<Space::Pose>&,
                                                  std::vector<PoseLink<Space>>&);
template Result<OptimiserOutcome> optimiseMultiStart<Space>(OptimiserOptions,
                                                            const std::vector<Space::Pose>&,
                                                            std::vector<Space::Pose>&,
                                                            std::vector<PoseLink<Space>>&);

}  // namespace tolman::experience_map
