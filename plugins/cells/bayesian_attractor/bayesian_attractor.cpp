// SPDX-License-Identifier: BSD-3-Clause
#include "bayesian_attractor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "activity.hpp"
#include "saved_state.hpp"

namespace tolman::bayesian_attractor {

namespace {

/// Distance between experiences of novel views over experience_spacing. Chosen, not tuned.
constexpr double kNovelSpacing = 0.2;

/// Slope of a steep road, rise over distance: the standard deviation of height over that of
/// position, for a view without measured pose. Chosen, not tuned.
constexpr double kSlope = 0.1;
/// Standard deviation of the height of a familiar view above its template over
/// experience_spacing, in addition to kSlope: 0.2 m for a car. Chosen, not tuned.
constexpr double kStep = 0.04;
/// Drift of path integration upwards over drift_position. Chosen, not tuned.
constexpr double kUpwards = 0.5;
/// Most storeys that one view is linked to; the oldest link is removed first. Bounds
/// memory and time.
constexpr std::size_t kMaxStoreys = 32;

}  // namespace

Status BayesianAttractor::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  localises_ = context.localise;
  Parameters& p = parameters_;
  if (p.period == 0) p.period = 30 * p.experience_spacing;
  if (p.view_sigma_position == 0) p.view_sigma_position = 0.6 * p.experience_spacing;
  if (p.loop_minimum_travel < 0) p.loop_minimum_travel = 6 * p.experience_spacing;
  if (p.loop_spacing < 0) p.loop_spacing = p.experience_spacing;
  return reset();
}

AttractorState BayesianAttractor::freshState() const {
  const Parameters& p = parameters_;
  const NetworkSettings network = {.period = p.period,
                                   .modules = p.modules,
                                   .phase_sigma = p.phase_sigma,
                                   .height_period = p.height_period,
                                   .drift_position = p.drift_position,
                                   .drift_heading = p.drift_heading,
                                   .drift_height = kUpwards * p.drift_position,
                                   .tail = p.drift_tail,
                                   .prior = p.prior,
                                   .injection = p.injection,
                                   .agreement = p.agreement,
                                   .inhibition = p.inhibition / p.experience_spacing,
                                   .threshold = p.threshold,
                                   .view_spacing = p.experience_spacing,
                                   .recalibrate = p.recalibrate,
                                   .localise = localises_};
  const ExperienceSettings experiences = {.spacing = p.experience_spacing,
                                          .novel_spacing = kNovelSpacing * p.experience_spacing,
                                          .loop_minimum_travel = p.loop_minimum_travel,
                                          .loop_spacing = p.loop_spacing};
  return {BumpNetwork(network), ExperienceLog(experiences), WaitingLoops(p.loop_spacing)};
}

Status BayesianAttractor::reset() {
  state_.emplace(freshState());
  return Status::ok();
}

Status BayesianAttractor::step(const Motion& motion, const PlaceObservation& observation,
                               Decision& decision) {
  const bool seen = observation.recognition != Recognition::None;
  if (seen && observation.template_id < 0) {
    return Status::invalidInput("a view was recognised, but its template_id is negative");
  }
  decision.frame = motion.frame;
  decision.stamp_ns = motion.stamp_ns;
  decision.template_id = seen ? observation.template_id : -1;
  integrate(motion);
  const bool known = seen && state_->links.contains(observation.template_id);
  const auto [calibrated, link] = known ? perceive(observation, motion.frame) : Perception{};
  decision.heading = state_->network.state().integrator.centre.heading;
  decision.hypotheses = state_->network.changes();
  for (PlaceHypothesis& changed : decision.hypotheses) {
    if (changed.id == calibrated.bump) changed.experience = link->experience;
  }
  if (localises_) {
    localise(observation, {calibrated, link}, decision);
    return Status::ok();
  }
  if (calibrated.joined_part >= 0 || !calibrated.traced.empty()) {
    for (auto& [id, storeys] : state_->links) {
      for (ViewLink& other : storeys) state_->network.follow(calibrated, other.learned);
    }
  }
  if (calibrated.accepted) {
    decision.earlier = state_->waiting.of(calibrated.bump, state_->network.state().travel);
  }
  if (calibrated.accepted && state_->log.allowsLoopTo(link->experience)) {
    closeLoop(observation, *link, calibrated.share, decision);
  } else if (state_->log.wantsNew(seen && !known)) {
    decision.action = Action::CreateExperience;
    state_->log.create();
  }
  if (seen && !known) learn(observation.template_id, {});
  decision.experience = state_->log.current();
  if (decision.action != Action::CloseLoop) {
    decision.relative_yaw = toPlanar(state_->log.fromCurrent()).theta;
  }
  return Status::ok();
}

void BayesianAttractor::integrate(const Motion& motion) {
  const bool initialising = motion.state == TrackingState::Initialising;
  if (initialising && !state_->initialising) {
    state_->network.startPart();
    state_->log.startPart();
    state_->known.reset();
  }
  state_->initialising = initialising;
  const Eigen::Vector3d up_before = state_->upright.up();
  state_->upright.add(motion.T_previous_current);
  const LevelStep moved = levelled(motion.T_previous_current, motion.covariance, up_before);
  state_->network.integrate(moved.plane, moved.covariance, moved.climb, motion.dt);
  state_->waiting.keep(state_->network.state().calibration);
  state_->log.advance(motion.T_previous_current);
  if (state_->known) followKnownPlace(motion);
}

LevelStep BayesianAttractor::levelled(const Eigen::Isometry3d& T_from_to,
                                      const Matrix6d& covariance,
                                      const Eigen::Vector3d& up_from) const {
  return parameters_.height_period > 0 ? levelStep(T_from_to, covariance, up_from)
                                       : planarStep(T_from_to, covariance);
}

/// Pose of the camera relative to the template. A view without measured pose is at the template,
/// turned by the relative yaw.
BayesianAttractor::SeenPose BayesianAttractor::seenPose(const PlaceObservation& view) const {
  if (view.has_relative_pose) return {view.T_template_current, view.covariance};
  Vector6d sigma = Vector6d::Constant(parameters_.view_sigma_heading);
  sigma.head<3>().setConstant(parameters_.view_sigma_position);
  sigma[1] *= kSlope;
  return {fromPlanar({0, 0, view.relative_yaw}), sigma.cwiseAbs2().asDiagonal()};
}

/// Step from the template to the camera. The up direction is the one estimated for the camera. A
/// familiar view is near its template, so on its storey: the measured climb, which a few landmarks
/// on one line leave open by metres, is fused with a prior of none.
LevelStep BayesianAttractor::offsetOf(const SeenPose& seen) const {
  LevelStep offset = levelled(seen.T_template_current, seen.covariance,
                              seen.T_template_current.linear() * state_->upright.up());
  const double slope = kSlope * std::hypot(offset.plane.x, offset.plane.y);
  const double step = kStep * parameters_.experience_spacing;
  const double prior = slope * slope + step * step;
  const double gain = prior / (prior + offset.climb.variance);
  offset.climb.metres *= gain;
  offset.climb.variance *= gain;
  return offset;
}

/// Whether the view is linked to several storeys of another part of the path. Such a view does not
/// determine on which of them the robot is.
bool BayesianAttractor::isAmbiguous(const std::vector<ViewLink>& links,
                                    const ViewLink& link) const {
  const BumpNetwork& network = state_->network;
  if (parameters_.height_period <= 0 || link.learned.part == network.state().part) return false;
  return std::ranges::any_of(links, [&](const ViewLink& other) {
    return other.learned.part == link.learned.part &&
           !network.onOneStorey(other.learned, link.learned);
  });
}

/// The link on the storey that the robot is most likely on; null where it is on none of them.
const ViewLink* BayesianAttractor::nearestStorey(std::int64_t template_id,
                                                 const Climb& climb) const {
  const ViewLink* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  const std::vector<ViewLink>& links = state_->links.at(template_id);
  for (const ViewLink& link : links) {
    if (isAmbiguous(links, link)) continue;
    const double misfit = state_->network.heightMisfit(link.learned, climb);
    if (misfit >= least) continue;
    least = misfit;
    nearest = &link;
  }
  return nearest;
}

/// Injects a familiar view, unless its template was learned within loop_minimum_travel. A view
/// whose links are all of other storeys is linked to the present one as well.
BayesianAttractor::Perception BayesianAttractor::perceive(const PlaceObservation& view,
                                                          std::int64_t frame) {
  if (view.recognition != Recognition::Familiar) return {};
  const SeenPose seen = seenPose(view);
  const ViewLink* link = nearestStorey(view.template_id, offsetOf(seen).climb);
  if (link == nullptr) {
    if (!localises_) learn(view.template_id, seen);
    return {};
  }
  if (localises_) return {injectView(seen, *link, frame), link};
  const NetworkState& network = state_->network.state();
  const bool recent = link->learned.part == network.part &&
                      network.travel - link->travel < parameters_.loop_minimum_travel;
  return recent ? Perception{} : Perception{injectView(seen, *link, frame), link};
}

Recalibration BayesianAttractor::injectView(const SeenPose& seen, const ViewLink& link,
                                            std::int64_t frame) {
  const LevelStep offset = offsetOf(seen);
  const Recalibration result =
      state_->network.inject(link.learned, offset.plane, offset.covariance, offset.climb);
  if (localises_ || result.bump < 0 || result.accepted ||
      !state_->log.allowsLoopTo(link.experience)) {
    return result;
  }
  state_->waiting.add(
      {result.bump,
       state_->network.state().travel,
       {frame, link.experience, normalised(link.T_experience_template * seen.T_template_current),
        seen.covariance}});
  return result;
}

void BayesianAttractor::closeLoop(const PlaceObservation& view, const ViewLink& link, double share,
                                  Decision& decision) {
  const SeenPose seen = seenPose(view);
  decision.action = Action::CloseLoop;
  decision.has_relative_pose = view.has_relative_pose;
  if (view.has_relative_pose) decision.covariance = view.covariance;
  decision.T_experience_current = normalised(link.T_experience_template * seen.T_template_current);
  decision.relative_yaw = toPlanar(decision.T_experience_current).theta;
  decision.confidence = share;
  state_->log.closeLoopTo(link.experience, decision.T_experience_current);
}

/// Says where in the map the robot is, if it knows.
void BayesianAttractor::localise(const PlaceObservation& view, const Perception& perceived,
                                 Decision& decision) {
  if (perceived.calibrated.accepted) {
    closeLoop(view, *perceived.link, perceived.calibrated.share, decision);
    state_->known = {state_->network.state().travel, seenPose(view).covariance};
  }
  decision.has_relative_pose = knowsPlace();
  if (!decision.has_relative_pose) {
    decision.action = Action::Stay;
    return;
  }
  decision.experience = state_->log.current();
  decision.T_experience_current = state_->log.fromCurrent();
  decision.covariance = state_->known->covariance;
  decision.relative_yaw = toPlanar(decision.T_experience_current).theta;
}

/// Path integration of the covariance.
void BayesianAttractor::followKnownPlace(const Motion& motion) {
  const Eigen::Isometry3d& step = motion.T_previous_current;
  const double length = step.translation().norm();
  const auto grown = [&](double drift) { return drift * drift * length; };
  const double along = grown(parameters_.drift_position);
  const double up = grown(kUpwards * parameters_.drift_position);
  const double turn = grown(parameters_.drift_heading);
  const Matrix6d A = adjointSe3(step.inverse());
  Matrix6d& covariance = state_->known->covariance;
  covariance = A * covariance * A.transpose() + motion.covariance;
  covariance.diagonal() += (Vector6d() << along, up, along, turn, turn, turn).finished();
}

/// The place is known for some way after a view has said where the robot is, unless another view
/// has said otherwise since, or path integration has become too vague.
bool BayesianAttractor::knowsPlace() const {
  constexpr double kWay = 6;      // experience spacings; chosen on KITTI 05's jumps
  constexpr double kVague = 1.5;  // experience spacings, standard deviation; chosen, not tuned
  if (!state_->known || !state_->network.state().calibration.empty()) return false;
  const double spacing = parameters_.experience_spacing;
  const double sigma = std::sqrt(state_->known->covariance.topLeftCorner<3, 3>().trace());
  return state_->network.state().travel - state_->known->travel < kWay * spacing &&
         sigma < kVague * spacing;
}

/// Links the template to the present pattern. A new view is seen where its template is.
void BayesianAttractor::learn(std::int64_t template_id, const SeenPose& seen) {
  const Eigen::Isometry3d T_current_template = seen.T_template_current.inverse();
  LevelStep back = levelled(T_current_template, Matrix6d::Zero(), state_->upright.up());
  back.climb.metres = -offsetOf(seen).climb.metres;
  const BumpNetwork& network = state_->network;
  LearnedPattern learned = network.currentPattern();
  learned.pattern = network.code().displaced(learned.pattern, back.plane, back.climb.metres);
  std::vector<ViewLink>& storeys = state_->links[template_id];
  if (storeys.size() >= kMaxStoreys) storeys.erase(storeys.begin());
  storeys.push_back({learned, network.state().travel, state_->log.current(),
                     normalised(state_->log.fromCurrent() * T_current_template)});
}

Status BayesianAttractor::save(std::ostream& stream) const { return saveState(*state_, stream); }

Status BayesianAttractor::load(std::istream& stream) {
  AttractorState loaded = freshState();
  const Status status = loadState(stream, loaded);
  state_.emplace(status.isOk() ? std::move(loaded) : freshState());
  if (localises_) state_->initialising = false;  // the first motion begins a part of the path
  return status;
}

void BayesianAttractor::arrays(std::vector<NamedArray>& arrays) const {
  appendArrays(state_->network, arrays);
}

Status BayesianAttractor::describe(std::vector<ArrayInfo>& arrays) const {
  describeArrays(state_->network, arrays);
  return Status::ok();
}

}  // namespace tolman::bayesian_attractor
