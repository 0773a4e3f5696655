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

/// Factor on the prior of turning errors before it is learned. Motions in space are those of
/// cameras, which turn rightly unless many loops say otherwise. Chosen, not tuned.
template <class G>
constexpr double kWidestPrior = std::is_same_v<G, Space> ? 1.0 / 64 : 1;

/// Covariance of the unknown motion over a gap. If a loop joins the part to an earlier one, it is
/// so large that the link has no influence; otherwise a unit covariance fixes the free pose of the
/// part.
template <class G>
MatrixOf<G> gapCovariance(bool unjoined) {
  constexpr double kLooseVariance = 1e9;      // m^2
  constexpr double kLooseVarianceTurn = 1e7;  // rad^2
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
  rejected_ = 0;
  for (Anchor& anchor : anchors_) {
    anchor.rejected = anchor.visit && anchor.offset_weight < parameters_.min_loop_weight;
    rejected_ += anchor.rejected ? 1 : 0;
  }
  if (status.isOk() && rejected_ > 0) {
    status = optimiseAll(path, {.iterations = iterations, .tolerance = tolerance}, Effort::Refined);
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
PoseGraph<G> ExperienceChain::problem(const DeadReckoning& path,
                                      std::vector<typename G::Pose>& reckoned) const {
  PoseGraph<G> graph;
  reckoned.reserve(anchors_.size());
  graph.nodes.reserve(anchors_.size());
  graph.links.reserve(2 * anchors_.size());
  for (const Anchor& anchor : anchors_) {
    reckoned.push_back(poseIn<G>(path[anchor.slot].T_start_camera));
    graph.nodes.push_back(compose(poseIn<G>(anchor.correction), reckoned.back()));
  }
  const PathParts joined = parts();
  for (std::size_t i = 1; i < anchors_.size(); ++i) {
    graph.links.push_back(odometryLink<G>(path, i, joined));
  }
  for (std::size_t i = 1; i < anchors_.size(); ++i) {
    if (anchors_[i].visit) graph.links.push_back(loopLink<G>(path, i));
  }
  for (const PoseLink<G>& link : graph.links) graph.assumed.push_back(link.covariance);
  if (!parameters_.recalibrate) return graph;
  SteadyErrors<G>& errors = graph.errors;
  errors.b = calibration_.errors.template head<kErrors<G>>();
  for (std::size_t i = 1; i < anchors_.size(); ++i) {
    errors.reported.push_back(graph.links[i - 1].pose);
    errors.effects.push_back(endProjection<G>(path[anchors_[i - 1].slot].T_start_camera,
                                              path[anchors_[i].slot].T_start_camera) *
                             anchors_[i].odometry.effect.template leftCols<kErrors<G>>());
  }
  Assumptions assumed = assumptions_;
  assumed.errors = std::min(assumed.errors, kWidestPrior<G>);
  assume<G>(assumed, graph);
  return graph;
}

/// While running, the steady errors are estimated each time that there are half as many loops more,
/// which bounds the time, and held in between.
template <class G>
void ExperienceChain::holdErrors(PoseGraph<G>& graph, bool always) {
  constexpr double kGrowth = 1.5;  // chosen, not tuned
  if (!parameters_.recalibrate) return;
  const std::size_t loops = graph.links.size() + 1 - anchors_.size();
  if (!always &&
      static_cast<double>(loops) >= kGrowth * static_cast<double>(loops_when_estimated_)) {
    loops_when_estimated_ = loops;
    return;
  }
  graph.errors.correct(graph.links);
  graph.errors.reported.clear();
  graph.errors.effects.clear();
}

template <class G>
Status ExperienceChain::optimiseIn(const DeadReckoning& path, OptimiserOptions options,
                                   Effort effort) {
  constexpr std::size_t kFinalAttempts = 10;  // bounds the time of the final correction
  options.loss = parameters_.loss;
  // The expected squared residual of a right link is its number of dimensions; the parameters are
  // for three dimensions.
  options.delta =
      std::sqrt(G::kSize / 3.0) *
      (options.loss == Loss::Huber ? parameters_.huber_delta : parameters_.geman_mcclure_scale);
  std::vector<typename G::Pose> reckoned;
  PoseGraph<G> found = problem<G>(path, reckoned);
  const SteadyErrors<G> errors = found.errors;
  // In space a false loop over a long way without loops would be a steady drift, so the drift is
  // learned from the loops that remain without it.
  if (effort == Effort::Online || std::is_same_v<G, Space>)
    holdErrors<G>(found, std::is_same_v<G, Space>);
  if (effort == Effort::Refined) return refine<G>(options, reckoned, found);
  const PathParts joined = parts();
  std::vector<typename G::Pose> start;  // the other arrangements of the parts begin there
  if (joined.count() > 1) start = found.nodes;
  BorderedSystem<G> system;
  const Result<OptimiserOutcome> outcome =
      effort == Effort::Online ? optimise<G>(options, found, system)
                               : optimiseMultiStart<G>(options, reckoned, found, system);
  if (!outcome.isOk()) return outcome.status();
  OptimiserOutcome best = outcome.value();
  rearrange<G>(joined, start, options, effort == Effort::Online ? 1 : kFinalAttempts, found, best,
               system);
  if (effort == Effort::Final && parameters_.recalibrate) {
    const ErrorsOf<G> b = found.errors.b;
    found.errors = errors;
    found.errors.b = b;
    if (Status status = recalibrate<G>(options, found, best, system); !status.isOk()) return status;
  }
  if (effort == Effort::Final) noteResiduals<G>(found);
  calibration_.errors.template head<kErrors<G>>() = found.errors.b;
  pending_ = !best.converged;
  apply<G>(reckoned, found);
  return Status::ok();
}

/// Even a rejected loop pulls a little at the map, and one of a long way much at the steady errors.
template <class G>
Status ExperienceChain::refine(const OptimiserOptions& options,
                               const std::vector<typename G::Pose>& reckoned, PoseGraph<G>& graph) {
  std::size_t loop = anchors_.size() - 1;
  for (const Anchor& anchor : anchors_) {
    if (!anchor.visit) continue;
    PoseLink<G>& link = graph.links[loop++];
    if (!anchor.rejected) continue;
    link.robust = false;
    link.weight = 0;
  }
  if (parameters_.recalibrate) centreAssumedLoops<G>(graph);
  BorderedSystem<G> system;
  const Result<OptimiserOutcome> outcome = optimise<G>(options, graph, system);
  if (!outcome.isOk()) return outcome.status();
  if (parameters_.recalibrate) noteCalibration<G>(graph, system);
  noteResiduals<G>(graph);
  apply<G>(reckoned, graph);
  return Status::ok();
}

/// Matches of views without measured pose may all come as early or late, which neither odometry nor
/// noise explains: what the map leaves of such an offset is common to them, and is taken from them.
template <class G>
void ExperienceChain::centreAssumedLoops(PoseGraph<G>& graph) const {
  constexpr int kLengths = G::kSize == 3 ? 2 : 3;  // the first coordinates of a step
  StepOf<G> sum = StepOf<G>::Zero();
  double weights = 0;
  const auto each = [&](const auto& action) {
    std::size_t loop = anchors_.size() - 1;
    for (const Anchor& anchor : anchors_) {
      if (!anchor.visit) continue;
      PoseLink<G>& link = graph.links[loop++];
      if (anchor.assumed) action(link);
    }
  };
  each([&](const PoseLink<G>& link) {
    sum += link.weight * residualOf(link, graph.nodes[link.from], graph.nodes[link.to]);
    weights += link.weight;
  });
  if (weights <= 0) return;
  StepOf<G> offset = StepOf<G>::Zero();
  offset.template head<kLengths>() = sum.template head<kLengths>() / weights;
  each([&](PoseLink<G>& link) { link.pose = corrected(link.pose, offset); });
}

/// Learns from the loops how large errors are, with poses and steady errors marginalised, and
/// optimises again under it. The start is the map as it is, and the map with odometry's errors
/// assumed larger, so that no right loop is rejected because the map is still wrong; the more
/// probable result is kept. Few loops agree by chance, and teach the steady errors only.
template <class G>
Status ExperienceChain::recalibrate(const OptimiserOptions& options, PoseGraph<G>& graph,
                                    OptimiserOutcome& outcome, BorderedSystem<G>& system) {
  constexpr double kRelaxed = 4;        // chosen, not tuned
  constexpr std::size_t kFewLoops = 3;  // chosen, not tuned
  const std::size_t loops = graph.links.size() + 1 - anchors_.size();
  if (loops >= kFewLoops) {
    centreAssumedLoops<G>(graph);
    Learned<G> best;
    for (const double relaxed : {kRelaxed, 1.0}) {
      if (std::is_same_v<G, Space> && relaxed > 1) continue;  // drives with gaps of loops
      Learned<G> learned = {.graph = graph, .assumed = assumptions_};
      learned.assumed.odometry_distance *= relaxed;
      learned.assumed.odometry_turns *= relaxed;
      learned.assumed.errors = kWidestPrior<G>;
      if (learnFrom<G>(options, learned, system).isOk() && learned.posterior > best.posterior) {
        best = std::move(learned);
      }
    }
    if (!std::isfinite(best.posterior)) return Status::failed("no error of odometry is learned");
    graph = std::move(best.graph);
    outcome = best.outcome;
    assumptions_ = best.assumed;
  }
  noteCalibration<G>(graph, system);
  return Status::ok();
}

template <class G>
Status ExperienceChain::learnFrom(const OptimiserOptions& options, Learned<G>& learned,
                                  BorderedSystem<G>& system) {
  constexpr int kRounds = 3;  // bounds the time; chosen, not tuned
  assume<G>(learned.assumed, learned.graph);
  if (const auto start = optimise<G>(options, learned.graph, system); !start.isOk()) {
    return start.status();
  }
  for (int round = 0; round < kRounds; ++round) {
    const Assumptions before = learned.assumed;
    learned.assumed = learnAssumptions<G>(learned.assumed, learned.graph, system);
    if (round > 0 && learned.assumed == before) break;
    const Result<OptimiserOutcome> again = optimise<G>(options, learned.graph, system);
    if (!again.isOk()) return again.status();
    learned.outcome = again.value();
  }
  learned.posterior =
      logPosterior<G>(learned.assumed, learned.graph, learned.outcome.energy, system);
  return Status::ok();
}

/// Stores what was learned, with standard deviations.
template <class G>
void ExperienceChain::noteCalibration(const PoseGraph<G>& graph, BorderedSystem<G>& system) {
  calibration_.noise_distance = assumptions_.odometry_distance;
  calibration_.noise_turns = assumptions_.odometry_turns;
  calibration_.errors.template head<kErrors<G>>() = graph.errors.b;
  const auto covariance = system.errorCovariance(graph);
  if (!covariance) return;
  calibration_.sigmas.template head<kErrors<G>>() = covariance->diagonal().cwiseSqrt();
  double length = 0;
  double seconds = 0;
  for (const Anchor& anchor : anchors_) {
    length += anchor.odometry.length;
    seconds -= anchor.odometry.effect(4, 1);
  }
  if (seconds <= 0) return;
  ErrorsOf<G> turning = ErrorsOf<G>::Zero();  // rad/s, of turns per second and per metre
  turning[1] = 1;
  turning[2] = length / seconds;
  calibration_.turning = turning.dot(graph.errors.b);
  calibration_.turning_sigma = std::sqrt(turning.dot(*covariance * turning));
}

/// Residuals of the loops in the standard deviations that were assumed at first.
template <class G>
void ExperienceChain::noteResiduals(const PoseGraph<G>& graph) {
  residuals_.clear();
  std::size_t k = anchors_.size() - 1;
  for (Anchor& anchor : anchors_) {
    if (!anchor.visit) continue;
    const PoseLink<G>& loop = graph.links[k];
    const StepOf<G> off = residualOf(loop, graph.nodes[loop.from], graph.nodes[loop.to]);
    const double chi_square = off.dot(informationOf(graph.assumed[k++]) * off);
    anchor.residual = std::sqrt(chi_square * 3 / G::kSize);
    if (loop.weight >= parameters_.min_loop_weight) residuals_.push_back(anchor.residual);
  }
}

template <class G>
void ExperienceChain::apply(const std::vector<typename G::Pose>& reckoned,
                            const PoseGraph<G>& graph) {
  std::size_t loop = anchors_.size() - 1;  // loop links follow all odometry links
  for (std::size_t i = 1; i < anchors_.size(); ++i) {
    Anchor& anchor = anchors_[i];
    anchor.correction = lifted(compose(graph.nodes[i], between(reckoned[i], G::identity())));
    anchor.odometry_weight = graph.links[i - 1].weight;
    if (anchor.visit && graph.links[loop].robust) anchor.offset_weight = graph.links[loop].weight;
    loop += anchor.visit ? 1 : 0;
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
