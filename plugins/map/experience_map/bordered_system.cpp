// SPDX-License-Identifier: BSD-3-Clause
#include "bordered_system.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tolman::experience_map {

template <class G>
void BorderedSystem<G>::linearise(const std::vector<typename G::Pose>& nodes,
                                  const std::vector<PoseLink<G>>& links,
                                  std::span<const double> curvatures,
                                  const SteadyErrors<G>& errors) {
  bordered_ = !errors.effects.empty();
  if (!bordered_) return chain_.linearise(nodes, links, curvatures);
  right_.assign(nodes.size(), Right::Zero());
  errors_information_ = errors.precision.asDiagonal();
  errors_gradient_ = errors.precision.cwiseProduct(errors.b);
  energy_ = errors.energy();
  log_prior_information_ = errors.precision.array().log().sum();
  log_information_ = log_prior_information_;
  chain_.linearise(nodes, links, curvatures, [&](std::size_t k, const LinkDerivatives<G>& by) {
    energy_ += links[k].weight * by.residual.dot(chain_.information()[k] * by.residual);
    // The information of a link is its weight's; constant factors do not matter here.
    log_information_ += std::min(1.0, links[k].weight) * chain_.logInformation()[k];
    if (k < errors.effects.size()) add(links[k], k, by, errors.effects[k]);
  });
  for (std::size_t k = 0; k < nodes.size(); ++k) right_[k].col(0) = chain_.gradient()[k];
}

template <class G>
void BorderedSystem<G>::add(const PoseLink<G>& link, std::size_t k, const LinkDerivatives<G>& by,
                            const EffectOf<G>& effect) {
  const EffectOf<G> by_errors = byErrors(effect, link, by);
  const EffectOf<G> weighted = link.weight * (chain_.information()[k] * by_errors);
  errors_information_.noalias() += by_errors.transpose() * weighted;
  errors_gradient_.noalias() += weighted.transpose() * by.residual;
  right_[link.from].template rightCols<kCount>().noalias() += by.by_from.transpose() * weighted;
  right_[link.to].template rightCols<kCount>().noalias() += by.by_to.transpose() * weighted;
}

template <class G>
bool BorderedSystem<G>::solve(double damping, std::vector<Step>& step, ErrorsOf<G>& error_step) {
  error_step.setZero();
  if (!bordered_) return chain_.solve(damping, step);
  if (!chain_.factorise(damping) || !chain_.template solveFor<1 + kCount>(right_, x_)) return false;
  Eigen::Matrix<double, 1 + kCount, 1 + kCount> product;  // -(g, C)' H^-1 (g, C)
  product.setZero();
  for (std::size_t k = 1; k < x_.size(); ++k) {
    product.noalias() += right_[k].transpose() * x_[k];
  }
  Square schur = errors_information_ + product.template bottomRightCorner<kCount, kCount>();
  schur.diagonal() += damping * errors_information_.diagonal();
  factors_.compute(schur);
  if (factors_.vectorD().minCoeff() <= 0) return false;
  const ErrorsOf<G> gradient = errors_gradient_ + product.template block<kCount, 1>(1, 0);
  error_step = -factors_.solve(gradient);
  reduction_ = product(0, 0) + gradient.dot(error_step);
  step.resize(x_.size());
  for (std::size_t k = 0; k < x_.size(); ++k) {
    step[k] = x_[k].col(0) + x_[k].template rightCols<kCount>() * error_step;
  }
  return error_step.allFinite();
}

template <class G>
double BorderedSystem<G>::logLikelihood() const {
  const double log_determinant = chain_.logDeterminant() + factors_.vectorD().array().log().sum();
  return -0.5 * (energy_ + reduction_ + log_determinant - log_information_);
}

template <class G>
double BorderedSystem<G>::logLikelihood(double energy) const {
  double log_information = log_prior_information_;
  for (const double information : chain_.logInformation()) log_information += information;
  return -0.5 * (energy + chain_.logDeterminant() + factors_.vectorD().array().log().sum() -
                 log_information);
}

template <class G>
void assume(const Assumptions& assumed, PoseGraph<G>& graph) {
  const std::size_t odometry = graph.errors.effects.size();
  for (std::size_t k = 0; k < graph.links.size(); ++k) {
    graph.links[k].covariance =
        k < odometry
            ? scaled<G>(graph.assumed[k], assumed.odometry_distance, assumed.odometry_turns)
            : scaled<G>(graph.assumed[k], assumed.loop_distance, assumed.loop_turns);
  }
  for (int k = 0; k < kErrors<G>; ++k) {
    const double factor = k < kPlanarErrors ? assumed.errors : 1;
    const double prior = factor * kSteadyPrior[static_cast<std::size_t>(k)];
    graph.errors.precision[k] = 1 / (prior * prior);
  }
}

namespace {

/// Logarithm of the prior probability, up to a constant: each factor is log-normal.
double logPrior(const Assumptions& assumed) {
  constexpr double kSpread = 1.4;  // of the logarithm: a factor of four; chosen, not tuned
  // Most odometries turn rightly to a sixteenth of the wide prior.
  constexpr double kUsual = 1.0 / 16;
  constexpr double kErrorSpread = 1.5;
  double sum = std::pow(std::log(assumed.errors / kUsual) / kErrorSpread, 2);
  for (const double factor : {assumed.odometry_distance, assumed.odometry_turns,
                              assumed.loop_distance, assumed.loop_turns}) {
    sum += std::pow(std::log(factor) / kSpread, 2);
  }
  return -0.5 * sum;
}

/// The factors that are learned. In space, cameras measure distances and loops, and turn rightly:
/// as many unknowns as in the plane would explain a loop over hills in too many ways.
template <class G>
std::vector<double Assumptions::*> learnedFactors() {
  if constexpr (G::kSize == 6) return {&Assumptions::odometry_turns};
  return {&Assumptions::odometry_turns, &Assumptions::loop_turns, &Assumptions::odometry_distance,
          &Assumptions::loop_distance, &Assumptions::errors};
}

/// Bounds what loops can claim that agree by chance, or because they are all at one end of the
/// path: the steady errors that explain their last millimetres would bend the rest of it. Chosen on
/// 06, in one go and in two sessions: with an eighth of the distances the map of two sessions is
/// worse than odometry.
bool isAllowed(const Assumptions& assumed) {
  constexpr double kLeast = 0.25;
  constexpr double kLeastTurns = 0.125;
  return assumed.errors <= 1 && assumed.odometry_turns >= kLeastTurns &&
         std::min({assumed.odometry_distance, assumed.loop_distance, assumed.loop_turns}) >= kLeast;
}

}  // namespace

template <class G>
Assumptions learnAssumptions(Assumptions assumed, PoseGraph<G>& graph, BorderedSystem<G>& system) {
  constexpr int kSteps = 20;  // at most; bounds the time; chosen, not tuned
  std::vector<StepOf<G>> step;
  ErrorsOf<G> error_step;
  const auto posterior = [&](const Assumptions& tried) {
    assume<G>(tried, graph);
    system.takeCovariances(graph.links);
    system.linearise(graph.nodes, graph.links, {}, graph.errors);
    if (!system.solve(0, step, error_step)) return -std::numeric_limits<double>::infinity();
    return system.logLikelihood() + logPrior(tried);
  };
  system.build(graph.nodes.size(), graph.links);
  double most = posterior(assumed);
  int steps = 0;
  const auto climb = [&](double Assumptions::*factor, double by) {
    Assumptions tried = assumed;
    tried.*factor *= by;
    if (!isAllowed(tried) || ++steps > kSteps) return false;
    const double found = posterior(tried);
    if (!(found > most)) return false;
    most = found;
    assumed = tried;
    return true;
  };
  for (bool moved = true; moved && steps < kSteps;) {
    moved = false;
    for (double Assumptions::*factor : learnedFactors<G>()) {
      const double by = factor == &Assumptions::errors ? 4 : 2;
      const bool up = climb(factor, by);
      while (climb(factor, up ? by : 1 / by)) moved = true;
      moved = moved || up;
    }
  }
  posterior(assumed);
  return assumed;
}

template <class G>
double logPosterior(const Assumptions& assumed, const PoseGraph<G>& graph, double energy,
                    BorderedSystem<G>& system) {
  if (!system.errorCovariance(graph)) return -std::numeric_limits<double>::infinity();
  return system.logLikelihood(energy) + logPrior(assumed);
}

template class BorderedSystem<Plane>;
template class BorderedSystem<Space>;
template void assume<Plane>(const Assumptions&, PoseGraph<Plane>&);
template void assume<Space>(const Assumptions&, PoseGraph<Space>&);
template Assumptions learnAssumptions<Plane>(Assumptions, PoseGraph<Plane>&,
                                             BorderedSystem<Plane>&);
template Assumptions learnAssumptions<Space>(Assumptions, PoseGraph<Space>&,
                                             BorderedSystem<Space>&);

template double logPosterior<Plane>(const Assumptions&, const PoseGraph<Plane>&, double,
                                    BorderedSystem<Plane>&);
template double logPosterior<Space>(const Assumptions&, const PoseGraph<Space>&, double,
                                    BorderedSystem<Space>&);

}  // namespace tolman::experience_map
