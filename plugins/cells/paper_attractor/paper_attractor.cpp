// SPDX-License-Identifier: BSD-3-Clause
#include "paper_attractor.hpp"

#include "activity.hpp"

namespace tolman::paper_attractor {
namespace {

NetworkSettings networkSettings(const PaperAttractorParameters& p, double energy) {
  NetworkSettings settings;
  settings.period = p.period;
  settings.energy = energy;
  settings.initial_calibration = p.initial_calibration;
  settings.floor = kFloor;
  settings.inhibition_of_calibration = p.inhibition_of_calibration;
  settings.inhibition_of_integrator = p.inhibition_of_integrator;
  return settings;
}

/// Pose of the camera in the coordinates of the view's template.
Eigen::Isometry3d fromTemplate(const PlaceObservation& observation) {
  return observation.has_relative_pose ? observation.T_template_current
                                       : fromPlanar({0, 0, observation.relative_yaw});
}

}  // namespace

Status PaperAttractor::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  return reset();
}

PaperAttractor::State PaperAttractor::freshState() const {
  const Parameters& p = parameters_;
  const HabituationSettings habituation = {.newest_ignored = p.newest_ignored,
                                           .first_ignored = p.first_views_ignored};
  const ExperienceSettings experience = {p.experience_spacing,  p.experience_turn, kNovelSpacing,
                                         p.loop_minimum_travel, p.loop_spacing,    false};
  return {SpatialCells(HeadDirectionRing(networkSettings(p, kEnergyHeading)),
                       GridTorus(networkSettings(p, kEnergyPosition), p.metres_per_cell),
                       {p.decision_heading, p.decision_position}),
          HabituatingViews<ViewLink>(habituation), ExperienceLog(experience)};
}

Status PaperAttractor::reset() {
  state_.emplace(freshState());
  return Status::ok();
}

/// A frame comes with the motion that ends at it, so path integration comes before injection; in
/// the other order views would inject one step late.
Status PaperAttractor::step(const Motion& motion, const PlaceObservation& observation,
                            Decision& decision) {
  const bool seen = observation.recognition != Recognition::None;
  if (seen && observation.template_id < 0) {
    return Status::invalidInput("a view was recognised, but its template_id is negative");
  }
  decision.frame = motion.frame;
  decision.stamp_ns = motion.stamp_ns;
  decision.template_id = seen ? observation.template_id : -1;

  integrate(motion);
  const bool novel = seen && state_->links.find(observation.template_id) == nullptr;
  const bool injected = perceive(motion, observation);
  const ViewLink* const link = seen ? state_->links.find(observation.template_id) : nullptr;
  const bool familiar = injected && state_->cells.familiar();
  if (familiar && state_->log.allowsLoopTo(link->experience)) {
    closeLoop(observation, *link, decision);
  } else if (state_->log.wantsNew(novel)) {
    decision.action = Action::CreateExperience;
    state_->log.create();
  }
  if (familiar) state_->cells.adoptEstimate();
  if (novel) learn(observation.template_id);

  decision.experience = state_->log.current();
  decision.heading = state_->cells.estimate().heading;
  if (decision.action != Action::CloseLoop) {
    decision.relative_yaw = toPlanar(state_->log.fromCurrent()).theta;
  }
  return Status::ok();
}

void PaperAttractor::integrate(const Motion& motion) {
  const bool initialising = motion.state == TrackingState::Initialising;
  if (initialising && !state_->initialising) {  // odometry has restarted: position unknown
    state_->cells.restartCalibrations();
    state_->log.startPart();
    state_->links.startPart();
  }
  state_->initialising = initialising;
  state_->cells.integrate(toPlanar(motion.T_previous_current));
  state_->log.advance(motion.T_previous_current);
}

/// Injection, then inhibition and estimation with each view.
bool PaperAttractor::perceive(const Motion& motion, const PlaceObservation& observation) {
  if (observation.recognition == Recognition::None) return false;
  SpatialCells& cells = state_->cells;
  const auto injection = state_->links.see(observation.template_id, {});
  const bool injects = injection && observation.recognition == Recognition::Familiar;
  if (injects) {
    cells.inject(cells.displaced(injection->place.learned, toPlanar(fromTemplate(observation))),
                 parameters_.injected_strength);
  }
  if (motion.state == TrackingState::Lost) cells.weakenIntegrators(kLostTrust);
  cells.settle();
  return injects;
}

void PaperAttractor::closeLoop(const PlaceObservation& observation, const ViewLink& link,
                               Decision& decision) {
  decision.action = Action::CloseLoop;
  decision.has_relative_pose = observation.has_relative_pose;
  decision.T_experience_current =
      normalised(link.T_experience_template * fromTemplate(observation));
  if (observation.has_relative_pose) decision.covariance = observation.covariance;
  decision.relative_yaw = toPlanar(decision.T_experience_current).theta;
  decision.confidence = state_->cells.calibrationShare();
  state_->log.closeLoopTo(link.experience, decision.T_experience_current);
}

/// One-shot learning: the new local view cell is linked to the present firing pattern.
void PaperAttractor::learn(std::int64_t template_id) {
  *state_->links.find(template_id) = {state_->cells.estimate(), state_->log.current(),
                                      state_->log.fromCurrent()};
}

void PaperAttractor::arrays(std::vector<NamedArray>& arrays) const {
  appendArrays(state_->cells, arrays);
}

Status PaperAttractor::describe(std::vector<ArrayInfo>& arrays) const {
  describeArrays(state_->cells, arrays);
  return Status::ok();
}

}  // namespace tolman::paper_attractor
