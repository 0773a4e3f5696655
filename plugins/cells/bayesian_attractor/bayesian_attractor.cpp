// SPDX-License-Identifier: BSD-3-Clause
#include "bayesian_attractor.hpp"

#include "activity.hpp"
#include "saved_state.hpp"

namespace tolman::bayesian_attractor {

namespace {

constexpr double kNovelSpacing = 1;  // m, between experiences that novel views create

/// Diagonal covariance of (x, y, heading) on the plane; correlations are dropped. x is the camera's
/// z, y its -x, heading turns about -y.
Eigen::Matrix3d planarVariance(const Matrix6d& covariance) {
  return Eigen::Vector3d(covariance(2, 2), covariance(0, 0), covariance(4, 4)).asDiagonal();
}

}  // namespace

Status BayesianAttractor::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  return reset();
}

AttractorState BayesianAttractor::freshState() const {
  const Parameters& p = parameters_;
  const NetworkSettings network = {
      p.period,     p.modules,   p.phase_sigma,       p.drift_position, p.drift_heading,
      p.drift_tail, p.prior,     p.prior_views,       p.injection,      p.agreement,
      p.inhibition, p.threshold, p.experience_spacing};
  const ExperienceSettings experiences = {p.experience_spacing, p.experience_turn, kNovelSpacing,
                                          p.loop_minimum_travel, p.loop_spacing};
  return {BumpNetwork(network), ExperienceLog(experiences), WaitingLoops(p.loop_spacing), {}, true};
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
  const auto link = state_->links.find(observation.template_id);
  const bool known = seen && link != state_->links.end();
  const Recalibration calibrated = known ? perceive(observation, motion.frame) : Recalibration{};
  if (calibrated.joined_part >= 0) {
    for (auto& [id, other] : state_->links) state_->network.rejoin(calibrated, other.learned);
  }
  if (calibrated.won) {
    decision.earlier = state_->waiting.of(calibrated.bump, state_->network.state().travel);
  }
  if (calibrated.won && state_->log.allowsLoopTo(link->second.experience)) {
    closeLoop(observation, link->second, calibrated.share, decision);
  } else if (state_->log.wantsNew(seen && !known)) {
    decision.action = Action::CreateExperience;
    state_->log.create();
  }
  if (seen && !known) learn(observation.template_id);
  decision.experience = state_->log.current();
  decision.heading = state_->network.state().integrator.centre.heading;
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
  }
  state_->initialising = initialising;
  state_->network.integrate(toPlanar(motion.T_previous_current), planarVariance(motion.covariance));
  state_->waiting.keep(state_->network.state().calibration);
  state_->log.advance(motion.T_previous_current);
}

/// Pose of the camera relative to the template. A view without measured pose is at the template,
/// turned by the relative yaw.
BayesianAttractor::SeenPose BayesianAttractor::seenPose(const PlaceObservation& view) const {
  if (view.has_relative_pose) return {view.T_template_current, view.covariance};
  Vector6d sigma = Vector6d::Constant(parameters_.view_sigma_heading);
  sigma.head<3>().setConstant(parameters_.view_sigma_position);
  return {fromPlanar({0, 0, view.relative_yaw}), sigma.cwiseAbs2().asDiagonal()};
}

Recalibration BayesianAttractor::perceive(const PlaceObservation& view, std::int64_t frame) {
  const ViewLink& link = state_->links.at(view.template_id);
  const double travel = state_->network.state().travel;
  if (view.recognition != Recognition::Familiar) return {};
  if (link.learned.part == state_->network.state().part &&
      travel - link.travel < parameters_.loop_minimum_travel)
    return {};
  const SeenPose seen = seenPose(view);
  const Recalibration fed = state_->network.inject(link.learned, toPlanar(seen.T_template_current),
                                                   planarVariance(seen.covariance));
  if (fed.bump < 0 || fed.won || !state_->log.allowsLoopTo(link.experience)) return fed;
  state_->waiting.add(
      {fed.bump,
       travel,
       {frame, link.experience, normalised(link.T_experience_template * seen.T_template_current),
        seen.covariance}});
  return fed;
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

void BayesianAttractor::learn(std::int64_t template_id) {
  state_->links[template_id] = {state_->network.present(), state_->network.state().travel,
                                state_->log.current(), state_->log.fromCurrent()};
}

Status BayesianAttractor::save(std::ostream& stream) const { return saveState(*state_, stream); }

Status BayesianAttractor::load(std::istream& stream) {
  AttractorState loaded = freshState();
  const Status status = loadState(stream, loaded);
  state_.emplace(status.isOk() ? std::move(loaded) : freshState());
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
