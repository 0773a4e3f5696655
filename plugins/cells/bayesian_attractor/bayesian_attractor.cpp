// SPDX-License-Identifier: BSD-3-Clause
#include "bayesian_attractor.hpp"

#include <array>

#include "activity.hpp"
#include "saved_state.hpp"

namespace tolman::bayesian_attractor {

namespace {

/// Covariance of (x, y, heading) on the plane in the axes of the camera: x is z, y is -x, heading
/// turns about -y.
void setPlanar(const Eigen::Matrix3d& planar, Matrix6d& covariance) {
  constexpr std::array<Eigen::Index, 3> kAxis = {2, 0, 4};
  const Eigen::Vector3d sign(1, -1, -1);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const auto a = static_cast<Eigen::Index>(i);
      const auto b = static_cast<Eigen::Index>(j);
      covariance(kAxis[i], kAxis[j]) = sign(a) * sign(b) * planar(a, b);
    }
  }
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
  const ExperienceSettings experiences = {p.experience_spacing, p.experience_turn, 1,
                                          p.loop_minimum_travel, p.loop_spacing};
  return {BumpNetwork(network), ExperienceLog(experiences), {}, true};
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
  const Recalibration calibrated = known ? perceive(observation) : Recalibration{};
  if (calibrated.joined_part >= 0) {
    for (auto& [id, other] : state_->links) state_->network.rejoin(calibrated, other.learned);
  }
  if (calibrated.won && state_->log.allowsLoopTo(link->second.experience)) {
    closeLoop(observation, link->second, calibrated, decision);
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
  // Along the plane are x and z, up is -y; order translation, rotation.
  const Matrix6d& claimed = motion.covariance;
  const Eigen::Vector3d planar(claimed(2, 2), claimed(0, 0), claimed(4, 4));
  state_->network.integrate(toPlanar(motion.T_previous_current), planar.asDiagonal());
  state_->log.advance(motion.T_previous_current);
}

Recalibration BayesianAttractor::perceive(const PlaceObservation& observation) {
  const ViewLink& link = state_->links.at(observation.template_id);
  const Parameters& p = parameters_;
  const double travel = state_->network.state().travel;
  if (observation.recognition != Recognition::Familiar) return {};
  if (link.learned.part == state_->network.state().part &&
      travel - link.travel < p.loop_minimum_travel)
    return {};
  Eigen::Vector3d sigma(p.view_sigma_position, p.view_sigma_position, p.view_sigma_heading);
  PlanarPose offset{0, 0, observation.relative_yaw};
  Eigen::Vector3d claimed = Eigen::Vector3d::Zero();
  if (observation.has_relative_pose) {
    offset = toPlanar(observation.T_template_current);
    const Matrix6d& c = observation.covariance;
    claimed = Eigen::Vector3d(c(2, 2), c(0, 0), c(4, 4));
    sigma.setZero();
  }
  const Eigen::Vector3d variance = sigma.cwiseAbs2() + claimed;
  return state_->network.inject(link.learned, offset, variance.asDiagonal());
}

void BayesianAttractor::closeLoop(const PlaceObservation& observation, const ViewLink& link,
                                  const Recalibration& calibrated, Decision& decision) {
  decision.action = Action::CloseLoop;
  decision.has_relative_pose = observation.has_relative_pose;
  // Without a measured pose: where the template was made, turned by the relative yaw.
  Eigen::Isometry3d T_template_current = observation.has_relative_pose
                                             ? observation.T_template_current
                                             : fromPlanar({0, 0, observation.relative_yaw});
  if (observation.has_relative_pose) decision.covariance = observation.covariance;
  if (calibrated.views > 1) {  // the bump knows better than its last view
    const PlanarPose correction = between(toPlanar(T_template_current), calibrated.offset);
    T_template_current = T_template_current * fromPlanar(correction);
    if (observation.has_relative_pose) setPlanar(calibrated.covariance, decision.covariance);
  }
  decision.T_experience_current = normalised(link.T_experience_template * T_template_current);
  decision.relative_yaw = toPlanar(decision.T_experience_current).theta;
  decision.confidence = calibrated.share;
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
