// SPDX-License-Identifier: BSD-3-Clause
// The correction of the chain: its links as a problem of the optimiser, and the solution back.
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "experience_chain.hpp"

namespace tolman::experience_map {
namespace {

/// Number of coordinates of a step that are lengths; they come first.
template <class G>
constexpr int kLengths = G::kSize == 3 ? 2 : 3;

/// Covariance of the unknown motion over a gap. If a loop joins the part to an earlier one, it is
/// so large that the link has no influence; otherwise a unit covariance fixes the free pose of the
/// part.
template <class G>
MatrixOf<G> gapCovariance(bool unjoined) {
  constexpr double kLooseVariance = 1e6;      // m^2
  constexpr double kLooseVarianceTurn = 1e4;  // rad^2
  if (unjoined) return MatrixOf<G>::Identity();
  StepOf<G> variances = StepOf<G>::Constant(kLooseVarianceTurn);
  variances.template head<kLengths<G>>().setConstant(kLooseVariance);
  return variances.asDiagonal();
}

}  // namespace

Status ExperienceChain::correct(const DeadReckoning& path, int iterations, double tolerance) {
  pending_ = false;
  if (last_visit_ == 0) return Status::ok();
  return optimiseAll(path, {.iterations = iterations, .tolerance = tolerance}, Effort::Online);
}

Status ExperienceChain::correctFinally(const DeadReckoning& path, int iterations,
                                       double tolerance) {
  pending_ = false;
  if (last_visit_ == 0) return Status::ok();
  Status status =
      optimiseAll(path, {.iterations = iterations, .tolerance = tolerance}, Effort::Final);
  for (Anchor& anchor : anchors_) {
    anchor.rejected = anchor.visit && anchor.offset_weight < parameters_.min_loop_weight;
  }
  countLinks();  // the odometry link after a rejected visit starts before that visit
  return status;
}

bool ExperienceChain::isSpatial(const DeadReckoning& path) const {
  if (parameters_.space != Geometry::Auto) return parameters_.space == Geometry::Space;
  return measured_ && path.isMetric() && !path.isPlanar();
}

Status ExperienceChain::optimiseAll(const DeadReckoning& path, OptimiserOptions options,
                                    Effort effort) {
  return isSpatial(path) ? optimiseIn<Space>(path, options, effort)
                         : optimiseIn<Plane>(path, options, effort);
}

template <class G>
ChainProblem<G> ExperienceChain::problem(const DeadReckoning& path) const {
  ChainProblem<G> problem;
  problem.reckoned.reserve(anchors_.size());
  problem.nodes.reserve(anchors_.size());
  problem.links.reserve(2 * anchors_.size());
  for (const Anchor& anchor : anchors_) {
    problem.reckoned.push_back(poseIn<G>(path[anchor.slot].T_start_camera));
    problem.nodes.push_back(compose(poseIn<G>(anchor.correction), problem.reckoned.back()));
  }
  const PathParts joined = parts();
  for (std::size_t i = 1; i < anchors_.size(); ++i) {
    problem.links.push_back(odometryLink<G>(path, i, joined));
  }
  for (std::size_t i = 1; i < anchors_.size(); ++i) {
    if (anchors_[i].visit) problem.links.push_back(loopLink<G>(path, i));
  }
  return problem;
}

template <class G>
Status ExperienceChain::optimiseIn(const DeadReckoning& path, OptimiserOptions options,
                                   Effort effort) {
  constexpr std::size_t kFinalAttempts = 10;         // bounds the time of the final correction
  constexpr double kToleranceBeforeLearning = 1e-6;  // of the energy; chosen, not tuned
  options.solver = parameters_.solver;
  options.loss = parameters_.loss;
  // The expected squared residual of a right link is its number of dimensions; the parameters are
  // for three dimensions.
  options.delta =
      std::sqrt(G::kSize / 3.0) *
      (options.loss == Loss::Huber ? parameters_.huber_delta : parameters_.geman_mcclure_scale);
  const bool learns =
      std::is_same_v<G, Space> && effort == Effort::Final && parameters_.learn_drift;
  OptimiserOptions first = options;  // coarser if another optimisation follows
  if (learns) first.tolerance = std::max(options.tolerance, kToleranceBeforeLearning);
  ChainProblem<G> found = problem<G>(path);
  const PathParts joined = parts();
  std::vector<typename G::Pose> start;  // the other arrangements of the parts begin there
  if (joined.count() > 1) start = found.nodes;
  ChainSystem<G> system;
  const Result<OptimiserOutcome> outcome =
      effort == Effort::Online
          ? optimise<G>(first, found.nodes, found.links, system)
          : optimiseMultiStart<G>(first, found.reckoned, found.nodes, found.links, system);
  if (!outcome.isOk()) return outcome.status();
  OptimiserOutcome best = outcome.value();
  rearrange<G>(joined, start, first, effort == Effort::Online ? 1 : kFinalAttempts, found, best,
               system);
  if constexpr (std::is_same_v<G, Space>) {
    if (learns) {
      Status status = learnDriftAndCorrect(path, options, found, best, system);
      if (!status.isOk()) return status;
    }
  }
  pending_ = !best.converged;
  apply<G>(found);
  return Status::ok();
}

/// Learns the drift from the loops that were not rejected, then optimises all links again under it.
Status ExperienceChain::learnDriftAndCorrect(const DeadReckoning& path,
                                             const OptimiserOptions& options,
                                             ChainProblem<Space>& found, OptimiserOutcome& outcome,
                                             ChainSystem<Space>& system) {
  const PathParts joined = parts();
  const auto adopt = [&](const DriftModel& drift) {
    drift_ = drift;
    for (std::size_t i = 1; i < anchors_.size(); ++i) {
      const double weight = found.links[i - 1].weight;
      found.links[i - 1] = odometryLink<Space>(path, i, joined);
      found.links[i - 1].weight = weight;
    }
  };
  std::vector<double> lengths;
  for (std::size_t i = 1; i < anchors_.size(); ++i) {
    lengths.push_back(anchors_[i].gap ? 0 : anchors_[i].odometry.length);
  }
  const DriftPrior prior = {parameters_.drift_rotation, parameters_.steady_drift};
  adopt({prior.rotation, Eigen::Vector3d::Zero()});
  adopt(learnDrift(found.nodes, found.links, lengths, prior, system));
  const Result<OptimiserOutcome> again = optimise<Space>(options, found.nodes, found.links, system);
  if (!again.isOk()) return again.status();
  outcome = again.value();
  return Status::ok();
}

template <class G>
void ExperienceChain::apply(const ChainProblem<G>& problem) {
  std::size_t loop = anchors_.size() - 1;  // loop links follow all odometry links
  for (std::size_t i = 1; i < anchors_.size(); ++i) {
    Anchor& anchor = anchors_[i];
    anchor.correction =
        lifted(compose(problem.nodes[i], between(problem.reckoned[i], G::identity())));
    anchor.odometry_weight = problem.links[i - 1].weight;
    if (anchor.visit) anchor.offset_weight = problem.links[loop++].weight;
  }
}

template <class G>
PoseLink<G> ExperienceChain::odometryLink(const DeadReckoning& path, std::size_t i,
                                          const PathParts& parts) const {
  const Anchor& before = anchors_[i - 1];
  const Anchor& anchor = anchors_[i];
  const Eigen::Isometry3d& T_start_from = path[before.slot].T_start_camera;
  const Eigen::Isometry3d T_from_to = T_start_from.inverse() * path[anchor.slot].T_start_camera;
  PoseLink<G> link = linkOf<G>(T_start_from, {T_from_to, anchor.odometry.covariance});
  link.from = i - 1;
  link.to = i;
  if constexpr (std::is_same_v<G, Space>) {
    link = withDrift(link, anchor.odometry.length, parameters_.drift_rotation, drift_);
  }
  if (anchor.gap) link.covariance = gapCovariance<G>(parts.first(parts.of(i)) == parts.of(i));
  link.robust = parameters_.huber_odometry && parameters_.loss == Loss::Huber;
  link.weight = anchor.odometry_weight;
  return link;
}

template <class G>
PoseLink<G> ExperienceChain::loopLink(const DeadReckoning& path, std::size_t i) const {
  const Anchor& visit = anchors_[i];
  PoseLink<G> link = linkOf<G>(path[origin(visit.experience).slot].T_start_camera, visit.offset);
  link.from = of_experience_[static_cast<std::size_t>(visit.experience)];
  link.to = i;
  link.weight = visit.offset_weight;
  return link;
}

template PlanarLink ExperienceChain::loopLink<Plane>(const DeadReckoning&, std::size_t) const;
template SpatialLink ExperienceChain::loopLink<Space>(const DeadReckoning&, std::size_t) const;

}  // namespace tolman::experience_map
