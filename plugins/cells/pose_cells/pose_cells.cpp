// SPDX-License-Identifier: BSD-3-Clause
// One cycle: view, attractor dynamics, path integration, estimate, decision.
#include "pose_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tolman::pose_cells {
namespace {

// README.md has the choice of kSupportRadius, on KITTI 00 and 06.
constexpr int kPeakRadius = 3;     // cells round the strongest one that count; OpenRatSLAM's
constexpr int kSupportRadius = 4;  // cells round a view's place that support it; 2 and 4 tried

void scaleToPeak(std::vector<float>& rates) {
  const float peak = *std::ranges::max_element(rates);
  if (!(peak > 0)) return;
  for (float& rate : rates) rate /= peak;
}

}  // namespace

Status PoseCells::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  excitation_ = gaussianKernel(kExcitationWidth, kExcitationVariance);
  inhibition_ = gaussianKernel(kInhibitionWidth, kInhibitionVariance);
  return reset();
}

Status PoseCells::reset() {
  const Parameters& p = parameters_;
  state_.emplace(State{
      ActivityVolume(p.side, p.side, p.headings),
      HabituatingViews<CellPose>({p.injected_energy, kActiveDecay, p.restore, p.newest_ignored}),
      ExperienceMemory<CellPose>(
          p.experience_threshold,
          [this](const CellPose& a, const CellPose& b) { return state_->volume.distance(a, b); }),
      {},
      {}});
  // In the middle, heading along x, as RatSLAM starts.
  state_->volume.add(p.side / 2, p.side / 2, 0, 1);
  state_->estimate = {0.5 * (p.side - p.side % 2), 0.5 * (p.side - p.side % 2), 0};
  return Status::ok();
}

double PoseCells::headingCells(double angle) const {
  return angle / (2 * std::numbers::pi) * parameters_.headings;
}

// The attractor mostly undoes a shift by a small part of a cell, so motions are added up until they
// reach `least_shift`.
void PoseCells::integrate(const Motion& motion) {
  PlanarPose& pending = state_->pending;
  pending = compose(pending, toPlanar(motion.T_previous_current));
  const double cell = parameters_.cell_size;
  if (std::hypot(pending.x, pending.y) >= parameters_.least_shift * cell) {
    state_->volume.move(pending.x / cell, pending.y / cell);
    pending.x = 0;
    pending.y = 0;
  }
  const double turn = headingCells(pending.theta);
  if (std::abs(turn) >= parameters_.least_shift) {
    state_->volume.turn(turn);
    pending = compose({0, 0, -pending.theta}, pending);
  }
}

CellPose PoseCells::moved(const CellPose& place, const PlanarPose& motion) const {
  const double cell = parameters_.cell_size;
  const double heading = place.theta / parameters_.headings * 2 * std::numbers::pi;
  const PlanarPose end = compose({place.x * cell, place.y * cell, heading}, motion);
  return {wrapPeriod(end.x / cell, parameters_.side), wrapPeriod(end.y / cell, parameters_.side),
          wrapPeriod(place.theta + headingCells(motion.theta), parameters_.headings)};
}

CellPose PoseCells::estimate() const {
  return moved(state_->volume.peak(kPeakRadius), state_->pending);
}

// The pending motion is not yet applied to the packet, so the energy is added where that motion
// would end at the view's place. A view near activity adds all of its energy, others less:
// look-alikes contradict the packet and each other.
void PoseCells::inject(const HabituatingViews<CellPose>::Injection& injection, double turned) {
  CellPose place = injection.place;
  place.theta += turned;
  place = moved(place, between(state_->pending, {}));
  const auto x = static_cast<int>(std::lround(place.x));
  const auto y = static_cast<int>(std::lround(place.y));
  const auto theta = static_cast<int>(std::lround(place.theta));
  ActivityVolume& volume = state_->volume;
  const auto alone = static_cast<float>(parameters_.unsupported);
  const float support = std::min(1.0F, volume.around(x, y, theta, kSupportRadius));
  volume.add(x, y, theta, static_cast<float>(injection.energy) * (alone + (1 - alone) * support));
}

Status PoseCells::step(const Motion& motion, const PlaceObservation& observation,
                       Decision& decision) {
  const bool seen = observation.recognition != Recognition::None;
  if (seen && observation.template_id < 0) {
    return Status::invalidInput("a view was recognised, but its template_id is negative");
  }
  State& state = *state_;
  decision.frame = motion.frame;
  decision.stamp_ns = motion.stamp_ns;
  integrate(motion);  // before the view, which is taken at the end of the motion
  const double turned = seen ? headingCells(observation.relative_yaw) : 0;
  if (seen) {
    const auto injection = state.views.see(observation.template_id, estimate());
    if (injection) inject(*injection, turned);
  }
  state.volume.attract(excitation_, inhibition_, static_cast<float>(kGlobalInhibition));
  state.estimate = estimate();

  if (seen) {
    decision.template_id = observation.template_id;
    // The pose at which the robot looks as in the template: without the view's turn against it.
    CellPose straight = state.estimate;
    straight.theta = wrapPeriod(straight.theta - turned, parameters_.headings);
    decision.action = state.experiences.decide(straight, observation.template_id);
    decision.relative_yaw = observation.relative_yaw;
  } else if (state.experiences.current() < 0) {
    decision.action = state.experiences.createFirst(state.estimate);
  }
  decision.experience = state.experiences.current();
  decision.heading = wrapPeriod(state.estimate.theta / parameters_.headings * 2 * std::numbers::pi,
                                2 * std::numbers::pi);
  return Status::ok();
}

void PoseCells::arrays(std::vector<NamedArray>& arrays) const {
  const int side = parameters_.side;
  const int headings = parameters_.headings;
  const auto layer = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  std::vector<float> ring(static_cast<std::size_t>(headings));
  std::vector<float> sheet(layer);
  ActivityVolume volume = state_->volume;  // moved below by the pending motion
  const PlanarPose& pending = state_->pending;
  volume.move(pending.x / parameters_.cell_size, pending.y / parameters_.cell_size);
  volume.turn(headingCells(pending.theta));
  const std::span<const float> values = volume.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    ring[i / layer] += values[i];
    sheet[i % layer] += values[i];
  }
  scaleToPeak(ring);
  scaleToPeak(sheet);
  const CellPose& e = state_->estimate;
  arrays.push_back({"hd.activity", {headings}, std::move(ring)});
  arrays.push_back({"grid.activity", {side, side}, std::move(sheet)});
  arrays.push_back(
      {"pose.estimate",
       {3},
       {static_cast<float>(e.x), static_cast<float>(e.y), static_cast<float>(e.theta)}});
}

Status PoseCells::describe(std::vector<ArrayInfo>& arrays) const {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double period = parameters_.side * parameters_.cell_size;
  const auto axis = [&](const char* name) {
    return ArrayAxis{name, "m", 0, parameters_.cell_size, period, {}};
  };
  arrays.push_back({"hd.activity",
                    ArrayKind::Activity,
                    "",
                    "sums of all cells of one heading, 1 at the most",
                    "",
                    {{"heading", "rad", 0, kTurn / parameters_.headings, kTurn, {}}}});
  arrays.push_back({"grid.activity",
                    ArrayKind::Activity,
                    "",
                    "sums of all cells of one position, 1 at the most",
                    "",
                    {axis("y"), axis("x")}});
  arrays.push_back({"pose.estimate",
                    ArrayKind::Values,
                    "cells",
                    "centre of the strongest activity",
                    "",
                    {{"component", "", 0, 1, 0, {"x", "y", "heading"}}}});
  return Status::ok();
}

}  // namespace tolman::pose_cells
