// SPDX-License-Identifier: BSD-3-Clause
#include "bayesian_attractor.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "activity.hpp"
#include "saved_state.hpp"

namespace tolman::bayesian_attractor {
namespace {

NetworkSettings networkSettings(const AttractorParameters& p, double energy) {
  return {p.period,
          energy,
          p.initial_calibration,
          p.floor,
          p.inhibition_of_calibration,
          p.inhibition_of_integrator};
}

NetworkSettings ringSettings(const AttractorParameters& p) {
  NetworkSettings settings = networkSettings(p, p.energy_heading);
  settings.on_circle = p.ring_bump == RingBump::VonMises;
  return settings;
}

/// All modules have bumps of one size; only their periods differ.
GridTorus gridModule(const AttractorParameters& p, int module) {
  NetworkSettings settings = networkSettings(p, p.energy_position);
  settings.period *= std::pow(p.module_ratio, module);
  return {settings, p.metres_per_cell};
}

std::vector<GridTorus> furtherModules(const AttractorParameters& p) {
  std::vector<GridTorus> further;
  for (int module = 1; module < p.modules; ++module) further.push_back(gridModule(p, module));
  return further;
}

Status check(const AttractorParameters& p) {
  const double half_period = 0.5 * p.period * p.metres_per_cell;
  if (p.experience_spacing < half_period && p.novel_spacing < half_period) return Status::ok();
  return Status::invalidParameter(
      "experience_spacing and novel_spacing must be less than half the period of the grid, " +
      std::to_string(half_period) + " m (period * metres_per_cell / 2)");
}

}  // namespace

Status BayesianAttractor::configure(const Context& context) {
  Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = std::move(bound).value();
  if (Status status = check(parameters_); !status.isOk()) return status;
  return reset();
}

BayesianAttractor::State BayesianAttractor::freshState() const {
  const Parameters& p = parameters_;
  const DecisionSettings decision = {p.consistency_gate, p.gate_heading,      p.gate_position,
                                     p.decision_heading, p.decision_position, p.decision_share,
                                     p.patience};
  const HabituationSettings habituation = {p.habituation_increment, p.habituation_recovery,
                                           p.newest_ignored, p.first_views_ignored};
  const ExperienceSettings experience = {p.experience_spacing, p.experience_turn, p.novel_spacing,
                                         p.loop_minimum_travel, p.loop_spacing};
  const EvidenceSettings evidence = {p.evidence_prior, p.evidence_views, p.evidence_gate,
                                     p.decisive_odds, 2 * p.metres_per_cell};
  const RelocationSettings relocation = {p.relocation_views, p.loop_spacing, p.evidence_gate,
                                         p.decisive_odds};
  return {SpatialCells(HeadDirectionRing(ringSettings(p)), gridModule(p, 0), decision,
                       furtherModules(p)),
          ViewLinks(habituation),
          ExperienceLog(experience),
          PathMemory({p.drift_heading, p.drift_scale}),
          ViewEvidence(evidence),
          Relocation(relocation)};
}

Status BayesianAttractor::reset() {
  state_.emplace(freshState());
  return Status::ok();
}

/// The cycle. Frames arrive with the motion that leads to their view, so path integration comes
/// before injection; the other order would inject one step behind.
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
  const Effect effect = perceive(motion, observation);
  const bool injected = effect == Effect::Injected || effect == Effect::Relocated;
  const ViewLink* const link = seen ? state_->links.find(observation.template_id) : nullptr;
  const bool familiar = injected && state_->cells.familiar();
  if (familiar && state_->log.allowsLoopTo(link->experience)) {
    closeLoop(observation, *link, decision);
  } else if (state_->log.wantsNew(seen && link == nullptr)) {
    decision.action = Action::CreateExperience;
    state_->log.create();
  }
  if (familiar) {
    state_->evidence.confirm(state_->cells.support().views);
    state_->cells.adoptEstimate();
    if (effect == Effect::Relocated) relearn();
  }
  if (seen && link == nullptr) learn(observation.template_id);

  decision.experience = state_->log.current();
  decision.heading = state_->cells.estimate().heading;
  if (decision.action != Action::CloseLoop) {
    decision.relative_yaw = toPlanar(state_->log.fromCurrent()).theta;
  }
  return Status::ok();
}

/// Odometry that begins anew says nothing of how the robot came here.
void BayesianAttractor::wakeUp() {
  state_->cells.forgetCalibration();
  state_->log.wakeUp();
  state_->links.wakeUp();
  state_->path.startPart();
  state_->relocation.forget();
}

void BayesianAttractor::integrate(const Motion& motion) {
  const bool initialising = motion.state == TrackingState::Initialising;
  if (initialising && !state_->initialising && state_->path.now().step > 0) wakeUp();
  state_->initialising = initialising;
  const PlanarPose step = toPlanar(motion.T_previous_current);
  state_->cells.integrate(step);
  state_->log.advance(motion.T_previous_current);
  // Along the plane are x and z, up is -y; order translation, rotation.
  const Matrix6d& claimed = motion.covariance;
  state_->path.advance(step, 0.5 * (claimed(0, 0) + claimed(2, 2)), claimed(4, 4));
}

/// Injection, then inhibition and estimation.
BayesianAttractor::Effect BayesianAttractor::perceive(const Motion& motion,
                                                      const PlaceObservation& observation) {
  const bool seen = observation.recognition != Recognition::None;
  Effect effect = Effect::None;
  if (seen) {
    state_->links.countView();
    if (observation.recognition == Recognition::Familiar) effect = inject(observation);
    if (effect == Effect::None || effect == Effect::RuledOut) state_->cells.noteUnsupportedView();
  }
  if (inhibits(observation.recognition, effect)) {
    const bool lost = motion.state == TrackingState::Lost;
    if (lost) state_->cells.weakenIntegrators(parameters_.lost_trust);
    state_->cells.settle();
  }
  return effect;
}

/// What is ruled out was no view of this place: the cells go on waiting for one.
bool BayesianAttractor::inhibits(Recognition recognition, Effect effect) const {
  switch (parameters_.inhibition) {
    case Inhibition::EveryFrame:
      return true;
    case Inhibition::EveryView:
      return recognition != Recognition::None && effect != Effect::RuledOut;
    case Inhibition::FamiliarViews:
      break;
  }
  return recognition == Recognition::Familiar && effect != Effect::RuledOut;
}

BayesianAttractor::Effect BayesianAttractor::inject(const PlaceObservation& observation) {
  if (!state_->links.activate(observation.template_id)) return Effect::None;
  const ViewLink& link = *state_->links.find(observation.template_id);
  double strength = strengthOf(observation, link.mark);
  const bool relocated = !(strength > 0) && relocates(observation, link.mark);
  if (relocated) strength = parameters_.metric_strength;
  if (!(strength > 0)) return Effect::RuledOut;
  const PlanarPose step = stepFromTemplate(observation).pose;
  state_->cells.inject(state_->cells.displaced(link.learned, step), strength);
  return relocated ? Effect::Relocated : Effect::Injected;
}

/// A view of a part of the path that the present one is not joined with, or wrongly.
bool BayesianAttractor::relocates(const PlaceObservation& observation, const PathMark& learned) {
  if (!parameters_.path_evidence || learned.part == state_->path.now().part) return false;
  const bool agreed = state_->relocation.agrees(state_->path, state_->evidence, learned,
                                                stepFromTemplate(observation));
  if (agreed) state_->evidence.count();
  return agreed;
}

/// Links that were made since the robot woke up hang on phases of a world that was not this one.
void BayesianAttractor::relearn() {
  const CellPose here = state_->cells.estimate();
  const PathMark& now = state_->path.now();
  state_->links.relearn(now.part, [&](const ViewLink& link) {
    return state_->cells.displaced(here, between(now.pose, link.mark.pose));
  });
}

/// Where the view puts the robot, seen from where its template was made.
UncertainStep BayesianAttractor::stepFromTemplate(const PlaceObservation& observation) const {
  const bool metric = observation.has_relative_pose;
  const Parameters& p = parameters_;
  const double position = metric ? p.measured_sigma_position : p.view_sigma_position;
  const double heading = metric ? p.measured_sigma_heading : p.view_sigma_heading;
  UncertainStep seen;
  seen.pose = metric ? toPlanar(observation.T_template_current)
                     : PlanarPose{0, 0, observation.relative_yaw};
  seen.covariance.diagonal() << position * position, position * position, heading * heading;
  if (metric) {
    const Matrix6d& claimed = observation.covariance;
    seen.covariance.diagonal() += Eigen::Vector3d(claimed(2, 2), claimed(0, 0), claimed(4, 4));
  }
  return seen;
}

/// Energy that the view may inject, in units of E.
double BayesianAttractor::strengthOf(const PlaceObservation& observation, const PathMark& learned) {
  const bool metric = observation.has_relative_pose;
  const double alone = metric ? parameters_.metric_strength : parameters_.injected_strength;
  if (!parameters_.path_evidence) return alone;
  if (!state_->path.reaches(learned)) return 0;
  switch (state_->evidence.judge(state_->path, learned, stepFromTemplate(observation))) {
    case Verdict::RuledOut:
      return 0;
    case Verdict::Plausible:
      return parameters_.injected_strength;
    case Verdict::Decisive:
      break;
  }
  return alone;
}

void BayesianAttractor::closeLoop(const PlaceObservation& observation, const ViewLink& link,
                                  Decision& decision) {
  decision.action = Action::CloseLoop;
  decision.has_relative_pose = observation.has_relative_pose;
  // Without a measured pose: where the template was made, turned by the relative yaw.
  const Eigen::Isometry3d T_template_current = observation.has_relative_pose
                                                   ? observation.T_template_current
                                                   : fromPlanar({0, 0, observation.relative_yaw});
  decision.T_experience_current = normalised(link.T_experience_template * T_template_current);
  if (observation.has_relative_pose) decision.covariance = observation.covariance;
  decision.relative_yaw = toPlanar(decision.T_experience_current).theta;
  decision.confidence = state_->cells.calibrationShare();
  state_->log.closeLoopTo(link.experience, decision.T_experience_current);
  state_->path.close(link.mark, stepFromTemplate(observation), parameters_.evidence_gate);
}

/// One-shot learning: the new local view cell is linked to the present firing pattern.
void BayesianAttractor::learn(std::int64_t template_id) {
  ViewLink link;
  link.learned = state_->cells.estimate();
  link.experience = state_->log.current();
  link.T_experience_template = state_->log.fromCurrent();
  link.mark = state_->path.now();
  state_->links.learn(template_id, link);
}

void BayesianAttractor::arrays(std::vector<NamedArray>& arrays) const {
  const Readout readout{parameters_.ring_units, parameters_.sheet_units, parameters_.field_width};
  appendArrays(state_->cells, readout, arrays);
}

Status BayesianAttractor::save(std::ostream& stream) const {
  return saveState(parameters_, *state_, stream);
}

Status BayesianAttractor::load(std::istream& stream) {
  State loaded = freshState();
  if (Status status = loadState(parameters_, stream, loaded); !status.isOk()) {
    state_.emplace(freshState());
    return status;
  }
  state_.emplace(std::move(loaded));
  return Status::ok();
}

}  // namespace tolman::bayesian_attractor
