// SPDX-License-Identifier: BSD-3-Clause
// Iteratively reweighted Gauss-Newton. Graduated non-convexity: Yang, Antonante, Tzoumas, Carlone,
// "Graduated Non-Convexity for Robust Spatial Perception", RA-L 2020, with the Geman-McClure loss.
#include "graph_optimiser.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::experience_map {
namespace {

/// If all weights are above this, no other start is tried. Chosen, not tuned.
constexpr double kAcceptedWeight = 0.5;

void moveAll(const std::vector<PlanarPose>& start, const std::vector<Eigen::Vector3d>& step,
             std::vector<PlanarPose>& nodes) {
  for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k] = moved(start[k], step[k]);
}

/// Equal to moved() of each node to first order. Each node is composed from the moved node before
/// it and the difference of their steps, so that each link of the chain changes by that difference
/// only, even if a small rotation moves the rest of a long path.
void moveAll(const std::vector<Eigen::Isometry3d>& start, const std::vector<Vector6d>& step,
             std::vector<Eigen::Isometry3d>& nodes) {
  nodes[0] = moved(start[0], step[0]);
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    const Eigen::Isometry3d T_before_here = start[k - 1].inverse() * start[k];
    const Vector6d more = step[k] - adjointSe3(T_before_here.inverse()) * step[k - 1];
    nodes[k] = moved(nodes[k - 1] * T_before_here, more);
  }
}

template <class G>
class GaussNewton {
 public:
  using Pose = typename G::Pose;
  using PoseLinks = std::vector<PoseLink<G>>;

  GaussNewton(const OptimiserOptions& options, PoseGraph<G>& graph, BorderedSystem<G>& system)
      : options_(options),
        nodes_(graph.nodes),
        links_(graph.links),
        errors_(graph.errors),
        system_(system) {
    system_.build(nodes_.size(), links_);
    chi_square_.resize(links_.size());
    curvatures_.resize(links_.size());
    errors_.correct(links_);
    computeResiduals();
  }

  /// Graduated non-convexity: mu decreases from a convex loss to 1, the Geman-McClure loss itself.
  Result<bool> anneal() {
    for (PoseLink<G>& link : links_) link.weight = 1;
    if (Status status = descendApproximately(); !status.isOk()) return status;
    double worst = 0;
    for (std::size_t k = 0; k < links_.size(); ++k) {
      if (links_[k].robust) worst = std::max(worst, chi_square_[k]);
    }
    constexpr double kMuFactor = 1.4;  // as in the paper by Yang et al.
    for (double mu = 2 * worst / (options_.delta * options_.delta); mu > 1; mu /= kMuFactor) {
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

  /// Sum of rho; does not depend on the weights.
  double energy() const {
    const double bound = options_.delta * options_.delta;
    double sum = errors_.energy();
    for (std::size_t k = 0; k < links_.size(); ++k) {
      const double chi = chi_square_[k];
      if (!links_[k].robust) {
        sum += links_[k].weight * chi;
        continue;
      }
      switch (options_.loss) {
        case Loss::Huber:
          sum += chi <= bound ? chi : 2 * options_.delta * std::sqrt(chi) - bound;
          break;
        case Loss::GemanMcclure:
          sum += bound * chi / (bound + chi);
          break;
      }
    }
    return sum;
  }

 private:
  /// Approximate least squares over all links: the start of graduated non-convexity.
  Status descendApproximately() {
    constexpr int kSteps = 20;             // chosen, not tuned: this is only the start
    constexpr double kMinDecrease = 0.01;  // relative; a smaller one ends it; chosen, not tuned
    double before = leastSquares();
    for (int i = 0; i < kSteps; ++i) {
      if (Status taken = step(); !taken.isOk()) return taken;
      const double after = leastSquares();
      if (before - after <= kMinDecrease * before) break;
      before = after;
    }
    return Status::ok();
  }

  /// Squared residuals of all links at the present nodes.
  void computeResiduals() {
    for (std::size_t k = 0; k < links_.size(); ++k) {
      const PoseLink<G>& link = links_[k];
      const StepOf<G> error = residualOf(link, nodes_[link.from], nodes_[link.to]);
      chi_square_[k] = error.dot(system_.information()[k] * error);
    }
  }

  /// Whether the energy will stay above its bound if each further iteration lowers it by
  /// `decrease`.
  bool cannotReachBound(int iteration, double decrease, double energy) const {
    constexpr int kFirst = 10;  // iterations before the rate is representative; chosen, not tuned
    const int left = options_.iterations - iteration - 1;
    return iteration >= kFirst && energy - left * decrease > options_.energy_bound;
  }

  /// Sets the weights (and curvatures) of the robust loss at the present residuals.
  void reweigh(double mu) {
    const double delta = options_.delta;
    for (std::size_t k = 0; k < links_.size(); ++k) {
      if (!links_[k].robust) continue;
      const double chi = chi_square_[k];
      const double bound = mu * delta * delta;
      const double root = bound / (bound + chi);
      switch (options_.loss) {
        case Loss::Huber:
          links_[k].weight = std::min(1.0, delta / std::max(std::sqrt(chi), 1e-300));
          break;
        case Loss::GemanMcclure:
          links_[k].weight = root * root;
          curvatures_[k] = curvatureOf(chi, bound);
          break;
      }
    }
  }

  /// -2 rho'' / rho' of the Geman-McClure loss as a function of the squared residual `chi`: with it
  /// the steps are Newton steps. It is limited to 0.5 / chi, so that along the residual at least
  /// half of the curvature of the weighted least squares remains, and the step decreases those too.
  static double curvatureOf(double chi, double bound) {
    return std::min(4 / (bound + chi), 0.5 / std::max(chi, 1e-300));
  }

  /// Weighted sum of squared residuals.
  double leastSquares() const {
    double sum = errors_.energy();
    for (std::size_t k = 0; k < links_.size(); ++k) sum += links_[k].weight * chi_square_[k];
    return sum;
  }

  /// One Levenberg-Marquardt step with fixed weights.
  Status step() {
    constexpr double kMinDamping = 1e-4;  // relative to the diagonal; chosen, not tuned
    constexpr double kMaxDamping = 1e8;   // beyond it the step is below rounding; chosen, not tuned
    start_ = nodes_;
    const ErrorsOf<G> errors_before = errors_.b;
    const double before = leastSquares();
    system_.linearise(nodes_, links_, curvatures_, errors_);
    for (double damping = damping_; damping < kMaxDamping;
         damping = std::max(kMinDamping, 10 * damping)) {
      if (!system_.solve(damping, step_, error_step_)) continue;
      moveAll(start_, step_, nodes_);
      errors_.b = errors_before + error_step_;
      errors_.correct(links_);
      computeResiduals();
      if (leastSquares() <= before * (1 + 1e-12) + 1e-300) {
        damping_ = damping > kMinDamping ? 0.1 * damping : 0;
        return Status::ok();
      }
    }
    nodes_ = start_;  // at a minimum, up to rounding
    errors_.b = errors_before;
    errors_.correct(links_);
    computeResiduals();
    if (before == 0 || system_.solve(0, step_, error_step_)) return Status::ok();
    return Status::failed("the normal equations of the map are singular");
  }

  OptimiserOptions options_;
  std::vector<Pose>& nodes_;
  PoseLinks& links_;
  SteadyErrors<G>& errors_;
  BorderedSystem<G>& system_;
  std::vector<double> chi_square_;  ///< of each link
  std::vector<double> curvatures_;  ///< of each link, see ChainSystem::linearise()
  std::vector<Pose> start_;         ///< the nodes before a step
  std::vector<StepOf<G>> step_;
  ErrorsOf<G> error_step_;
  double damping_ = 0;
};

}  // namespace

template <class G>
Result<OptimiserOutcome> optimise(const OptimiserOptions& options, PoseGraph<G>& graph,
                                  BorderedSystem<G>& system) {
  std::vector<typename G::Pose> start = graph.nodes;
  const ErrorsOf<G> errors = graph.errors.b;
  const std::vector<double> weights = weightsOf(graph.links);
  GaussNewton<G> descent(options, graph, system);
  const bool annealed = options.annealed && options.loss == Loss::GemanMcclure;
  const Result<bool> converged = annealed ? descent.anneal() : descent.descend();
  if (converged.isOk()) return OptimiserOutcome{converged.value(), descent.energy()};
  graph.nodes = std::move(start);
  graph.errors.b = errors;
  setWeights(graph.links, weights);
  return converged.status();
}

namespace {

/// Steady turns per metre that the headings of most loops agree with, the likeliest first. Headings
/// are linear in the turn, however the shape of the path changes, but leave out whole turns.
template <class G>
std::vector<ErrorsOf<G>> turnsOfMostLoops(const PoseGraph<G>&) {
  return {};
}

template <>
std::vector<ErrorsOf<Plane>> turnsOfMostLoops<Plane>(const PoseGraph<Plane>& graph) {
  constexpr int kTurn = steady_error::kTurnPerMetre;
  constexpr double kRange = 3;      // standard deviations of the prior
  constexpr double kStep = 0.1;     // rad, of the longest loop; chosen, not tuned
  constexpr double kBound = 16;     // squared standard deviations; chosen, not tuned
  constexpr std::size_t kMost = 3;  // turns; with the next one bounds the time
  constexpr double kMostSteps = 2000;
  constexpr std::size_t kFewest = 20;  // loops; a few false ones agree by chance; on 06
  const std::size_t count = graph.errors.effects.size();
  std::vector<Eigen::Vector3d> sums = {Eigen::Vector3d::Zero()};  // turn, effect, variance
  for (std::size_t k = 0; k < count; ++k) {
    sums.push_back(sums.back() + Eigen::Vector3d(graph.errors.reported[k].theta,
                                                 graph.errors.effects[k](2, kTurn),
                                                 graph.links[k].covariance(2, 2)));
  }
  std::vector<Eigen::Vector3d> loops;  // turn that is missing, effect, precision
  double longest = 0;
  for (std::size_t k = count; k < graph.links.size() && count > 0; ++k) {
    const PlanarLink& link = graph.links[k];
    const Eigen::Vector3d way = sums[link.to] - sums[link.from];
    loops.emplace_back(link.pose.theta - way[0], way[1], 1 / (way[2] + link.covariance(2, 2)));
    longest = std::max(longest, std::abs(way[1]));
  }
  if (longest <= 0 || loops.size() < kFewest) return {};
  const double precision = graph.errors.precision[kTurn];
  const double range = kRange / std::sqrt(precision);
  const double step = std::max(kStep / longest, 2 * range / kMostSteps);
  std::vector<std::pair<double, double>> scan;  // cost, turn
  for (int i = -static_cast<int>(range / step); i * step <= range; ++i) {
    const double turn = i * step;
    double cost = precision * turn * turn;
    for (const Eigen::Vector3d& loop : loops) {
      const double off = wrapAngle(loop[0] - turn * loop[1]);
      const double chi_square = off * off * loop[2];
      cost += kBound * chi_square / (kBound + chi_square);
    }
    scan.emplace_back(cost, turn);
  }
  std::vector<std::pair<double, double>> minima;
  for (std::size_t i = 1; i + 1 < scan.size(); ++i) {
    if (scan[i].first < scan[i - 1].first && scan[i].first <= scan[i + 1].first)
      minima.push_back(scan[i]);
  }
  std::ranges::sort(minima);
  std::vector<ErrorsOf<Plane>> turns;
  for (std::size_t i = 0; i < std::min(kMost, minima.size()); ++i) {
    turns.emplace_back(minima[i].second * ErrorsOf<Plane>::Unit(kTurn));
  }
  return turns;
}

/// Dead reckoning with these errors.
template <class G>
std::vector<typename G::Pose> traced(PoseGraph<G>& graph, const ErrorsOf<G>& errors) {
  graph.errors.b = errors;
  graph.errors.correct(graph.links);
  std::vector<typename G::Pose> nodes = {graph.nodes.front()};
  for (std::size_t k = 0; k + 1 < graph.nodes.size(); ++k) {
    nodes.push_back(compose(nodes.back(), graph.links[k].pose));
  }
  return nodes;
}

}  // namespace

template <class G>
Result<OptimiserOutcome> optimiseMultiStart(OptimiserOptions options,
                                            const std::vector<typename G::Pose>& reckoned,
                                            PoseGraph<G>& graph, BorderedSystem<G>& system) {
  using Poses = std::vector<typename G::Pose>;
  using Weights = std::vector<double>;
  Poses kept_nodes = graph.nodes;
  ErrorsOf<G> kept_errors = graph.errors.b;
  const Poses start = graph.nodes;
  const ErrorsOf<G> start_errors = graph.errors.b;
  const Weights initial = weightsOf(graph.links);
  Result<OptimiserOutcome> best = optimise<G>(options, graph, system);
  if (options.loss == Loss::Huber) return best;
  const bool all_accepted = std::ranges::all_of(
      graph.links, [](const PoseLink<G>& link) { return link.weight > kAcceptedWeight; });
  if (best.isOk() && best.value().converged && all_accepted) return best;
  Weights kept = weightsOf(graph.links);
  kept_nodes = graph.nodes;
  kept_errors = graph.errors.b;
  const auto attempt = [&](const Poses& from, const ErrorsOf<G>& errors, const Weights& weights) {
    graph.nodes = from;
    graph.errors.b = errors;
    setWeights(graph.links, weights);
    if (best.isOk()) options.energy_bound = best.value().energy;
    const Result<OptimiserOutcome> outcome = optimise<G>(options, graph, system);
    if (!outcome.isOk()) return;
    if (best.isOk() && best.value().energy <= outcome.value().energy) return;
    best = outcome;
    kept_nodes = graph.nodes;
    kept_errors = graph.errors.b;
    kept = weightsOf(graph.links);
  };
  options.annealed = true;
  attempt(start, start_errors, initial);
  options.annealed = false;
  Weights without_loops;
  for (const PoseLink<G>& link : graph.links) {
    without_loops.push_back(link.robust ? kRejectedWeight : 1);
  }
  attempt(reckoned, ErrorsOf<G>::Zero(), without_loops);
  for (const ErrorsOf<G>& turn : turnsOfMostLoops<G>(graph)) {
    attempt(traced<G>(graph, turn), turn, without_loops);
  }
  graph.nodes = std::move(kept_nodes);
  graph.errors.b = kept_errors;
  graph.errors.correct(graph.links);
  setWeights(graph.links, kept);
  return best;
}

template Result<OptimiserOutcome> optimise<Plane>(const OptimiserOptions&, PoseGraph<Plane>&,
                                                  BorderedSystem<Plane>&);
template Result<OptimiserOutcome> optimiseMultiStart<Plane>(OptimiserOptions,
                                                            const std::vector<PlanarPose>&,
                                                            PoseGraph<Plane>&,
                                                            BorderedSystem<Plane>&);
template Result<OptimiserOutcome> optimise<Space>(const OptimiserOptions&, PoseGraph<Space>&,
                                                  BorderedSystem<Space>&);
template Result<OptimiserOutcome> optimiseMultiStart<Space>(OptimiserOptions,
                                                            const std::vector<Eigen::Isometry3d>&,
                                                            PoseGraph<Space>&,
                                                            BorderedSystem<Space>&);

}  // namespace tolman::experience_map
