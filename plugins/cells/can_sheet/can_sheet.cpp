// SPDX-License-Identifier: BSD-3-Clause
#include "can_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "saved_state.hpp"

namespace tolman::can_sheet {
namespace {

constexpr double kRingWidth = 0.5;  // rad, of the bump of heading; chosen, not tuned

/// The camera relative to the template. A view without measured pose is at the template.
Eigen::Isometry3d seenPose(const PlaceObservation& view) {
  return view.has_relative_pose ? view.T_template_current : fromPlanar({0, 0, view.relative_yaw});
}

/// The displacement in the plane of the grid by a motion that begins with this heading.
Eigen::Vector2d displacementOf(double heading, const PlanarPose& motion) {
  const PlanarPose moved = compose({0, 0, heading}, motion);
  return {moved.x, moved.y};
}

}  // namespace

Status CanSheet::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  const Parameters& p = parameters_;
  at_rest_.emplace(SheetSettings{.units = p.units});
  return reset();
}

Status CanSheet::reset() {
  state_.emplace();
  state_->sheets.assign(static_cast<std::size_t>(parameters_.modules), *at_rest_);
  return Status::ok();
}

double CanSheet::periodOf(std::size_t module) const {
  return parameters_.period * std::pow(parameters_.ratio, static_cast<double>(module));
}

Phase CanSheet::phaseOf(const Eigen::Vector2d& displacement, std::size_t module) const {
  const double c = std::cos(parameters_.orientation);
  const double s = std::sin(parameters_.orientation);
  const Eigen::Vector2d turned(c * displacement.x() + s * displacement.y(),
                               c * displacement.y() - s * displacement.x());
  return toPhase(turned / periodOf(module));
}

Status CanSheet::step(const Motion& motion, const PlaceObservation& observation,
                      Decision& decision) {
  const bool seen = observation.recognition != Recognition::None;
  if (seen && observation.template_id < 0) {
    return Status::invalidInput("a view was recognised, but its template_id is negative");
  }
  decision.frame = motion.frame;
  decision.stamp_ns = motion.stamp_ns;
  decision.template_id = seen ? observation.template_id : -1;
  const PlanarPose planar = toPlanar(motion.T_previous_current);
  const Eigen::Vector2d displacement = displacementOf(state_->heading, planar);
  state_->heading = wrapPeriod(state_->heading + planar.theta, 2 * std::numbers::pi);
  const bool novel = seen && !state_->links.contains(observation.template_id);
  integrate(motion, displacement);
  if (injects(observation)) {
    inject(state_->links.at(observation.template_id), toPlanar(seenPose(observation)),
           displacement);
  }
  for (std::size_t i = 0; i < state_->sheets.size(); ++i) {
    state_->sheets[i].step(phaseOf(displacement, i));
  }
  decodePosition();
  decide(observation, novel, decision);
  if (novel) learn(observation.template_id);
  decision.experience = state_->current;
  decision.heading = state_->heading;
  return Status::ok();
}

void CanSheet::integrate(const Motion& motion, const Eigen::Vector2d& displacement) {
  SheetState& state = *state_;
  const bool initialising = motion.state == TrackingState::Initialising;
  if (initialising && !state.initialising && state.current >= 0) {
    state.new_part = state.relocating = true;  // earlier views may inject at once
    state.travel += std::max(parameters_.loop_minimum_travel, parameters_.loop_spacing);
  }
  state.initialising = initialising;
  state.travel += motion.T_previous_current.translation().norm();
  state.position += displacement;
  for (auto* T : {&state.T_experience_current, &state.T_made_current}) {
    *T = normalised(*T * motion.T_previous_current);
  }
}

bool CanSheet::injects(const PlaceObservation& view) const {
  const auto link = state_->links.find(view.template_id);
  if (view.recognition != Recognition::Familiar || link == state_->links.end()) return false;
  const double since = state_->travel - link->second.travel;
  return since >= parameters_.loop_minimum_travel &&
         state_->travel - state_->travel_at_view >= kViewSpacing;
}

/// Phase of the robot in the module, by the view's link and its relative pose.
Phase CanSheet::placeOf(const ViewLink& link, const PlanarPose& seen, std::size_t module) const {
  return link.phases[module] + phaseOf(displacementOf(link.heading, seen), module);
}

// The motion to this frame is applied to the sheets after this, so the view's bump is placed one
// displacement back.
void CanSheet::inject(const ViewLink& link, const PlanarPose& seen,
                      const Eigen::Vector2d& displacement) {
  const bool lost = state_->relocating && parameters_.injection > 0;
  const double share =
      lost ? 1 : parameters_.injection;  // position unknown: as much as the present activity
  for (std::size_t i = 0; i < state_->sheets.size(); ++i) {
    state_->sheets[i].inject(placeOf(link, seen, i) - phaseOf(displacement, i), share);
  }
  // Only a heading near that of the ring has an effect; in the sheets, too, activity far from the
  // bump decays.
  const double off = wrapAngle(link.heading + seen.theta - state_->heading);
  const double near = std::exp(-0.5 * off * off / (kRingWidth * kRingWidth));
  const double taken = state_->relocating ? 1 : near * share / (1 + share);
  state_->heading = wrapPeriod(state_->heading + taken * off, 2 * std::numbers::pi);
  state_->travel_at_view = state_->travel;
}

bool CanSheet::agrees(const ViewLink& link, const PlanarPose& seen) const {
  const double turned = wrapAngle(link.heading + seen.theta - state_->heading);
  if (std::abs(turned) > kRingWidth) return false;
  for (std::size_t i = 0; i < state_->sheets.size(); ++i) {
    const Phase off = state_->sheets[i].phase() - placeOf(link, seen, i);
    if (shortest(off).norm() > parameters_.agreement) return false;
  }
  return true;
}

// The position nearest to the integrated one that has the phases of the modules. Each module
// corrects it by less than its period; the smallest, most precise module is the last.
void CanSheet::decodePosition() {
  const double c = std::cos(parameters_.orientation);
  const double s = std::sin(parameters_.orientation);
  for (std::size_t i = state_->sheets.size(); i-- > 0;) {
    const Eigen::Vector2d off =
        periodOf(i) * shortest(state_->sheets[i].phase() - phaseOf(state_->position, i));
    state_->position += Eigen::Vector2d(c * off.x() - s * off.y(), s * off.x() + c * off.y());
  }
}

void CanSheet::closeLoop(const PlaceObservation& view, Decision& decision) {
  const ViewLink& link = state_->links.at(view.template_id);
  const Eigen::Isometry3d T_template_current = seenPose(view);
  decision.action = Action::CloseLoop;
  decision.has_relative_pose = view.has_relative_pose;
  if (view.has_relative_pose) decision.covariance = view.covariance;
  decision.T_experience_current = normalised(link.T_experience_template * T_template_current);
  decision.relative_yaw = toPlanar(decision.T_experience_current).theta;
  state_->current = link.experience;
  state_->T_experience_current = decision.T_experience_current;
  state_->travel_at_loop = state_->travel;
  state_->new_part = state_->relocating = false;
}

void CanSheet::decide(const PlaceObservation& view, bool novel, Decision& decision) {
  SheetState& state = *state_;
  const Parameters& p = parameters_;
  const bool familiar = view.recognition == Recognition::Familiar && !novel;
  if (familiar) {
    const ViewLink& link = state.links.at(view.template_id);
    const bool due = state.travel - link.travel >= p.loop_minimum_travel &&
                     state.travel - state.travel_at_loop >= p.loop_spacing;
    if (due && (link.experience != state.current || state.new_part) &&
        agrees(link, toPlanar(seenPose(view)))) {
      closeLoop(view, decision);
      return;
    }
  }
  const PlanarPose since = toPlanar(state.T_made_current);
  if (state.current < 0 || state.new_part || std::hypot(since.x, since.y) >= p.experience_spacing ||
      std::abs(since.theta) >= p.experience_turn) {
    decision.action = Action::CreateExperience;
    state.current = state.experiences++;
    state.T_experience_current.setIdentity();
    state.T_made_current.setIdentity();
    state.new_part = false;
  }
  decision.relative_yaw = toPlanar(state.T_experience_current).theta;
}

void CanSheet::learn(std::int64_t template_id) {
  ViewLink link{{}, state_->heading, state_->travel, state_->current, state_->T_experience_current};
  for (const AttractorSheet& sheet : state_->sheets) link.phases.push_back(sheet.phase());
  state_->links[template_id] = link;
}

Status CanSheet::save(std::ostream& stream) const { return saveState(*state_, stream); }

Status CanSheet::load(std::istream& stream) {
  if (Status status = reset(); !status.isOk()) return status;
  const Status status = loadState(stream, *state_);
  if (!status.isOk()) (void)reset();
  return status;
}

}  // namespace tolman::can_sheet
