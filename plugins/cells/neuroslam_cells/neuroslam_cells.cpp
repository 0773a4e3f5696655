// SPDX-License-Identifier: BSD-3-Clause
// One cycle: motion, view, attractor dynamics, estimate, decision.
#include "neuroslam_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tolman::neuroslam_cells {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

void scaleToPeak(std::vector<float>& rates) {
  const float peak = *std::ranges::max_element(rates);
  if (!(peak > 0)) return;
  for (float& rate : rates) rate /= peak;
}

}  // namespace

double distance(const ConjunctivePlace& a, const ConjunctivePlace& b, double side,
                double headings) {
  const double x = std::remainder(b.x - a.x, side);
  const double y = std::remainder(b.y - a.y, side);
  const double height = std::remainder(b.height - a.height, side);
  return std::hypot(std::hypot(x, y, height), std::remainder(b.heading - a.heading, headings));
}

Status NeuroslamCells::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  grid_excitation_ = gaussianKernel(kGridExcitationWidth, kGridExcitationVariance);
  grid_inhibition_ = gaussianKernel(kGridInhibitionWidth, kGridInhibitionVariance);
  head_excitation_ = gaussianKernel(kHeadExcitationWidth, kHeadExcitationVariance);
  head_inhibition_ = gaussianKernel(kHeadInhibitionWidth, kHeadInhibitionVariance);
  return reset();
}

Status NeuroslamCells::reset() {
  const Parameters& p = parameters_;
  const auto between = [&p](const ConjunctivePlace& a, const ConjunctivePlace& b) {
    return distance(a, b, p.side, p.headings);
  };
  state_.emplace(State{ActivityVolume(p.headings, p.side, 1),
                       ActivityVolume(p.side, p.side, p.side),
                       HabituatingViews<ConjunctivePlace>({1, kActiveDecay, p.restore}),
                       ExperienceMemory<ConjunctivePlace>(p.experience_threshold, between)});
  const int middle_cell = p.side / 2;
  const auto middle = static_cast<double>(middle_cell);
  state_->grid.add(middle_cell, middle_cell, middle_cell, 1);
  state_->head.add(0, middle_cell, 0, 1);
  state_->estimate = {middle, middle, middle, 0};
  return Status::ok();
}

double NeuroslamCells::headingCells(double angle) const {
  return angle / kTurn * parameters_.headings;
}

double NeuroslamCells::radians(double heading) const {
  return heading / parameters_.headings * kTurn;
}

ConjunctivePlace NeuroslamCells::estimate() const {
  const CellPose head = state_->head.peak(kHeadPacket);
  const CellPose grid = state_->grid.peak(kGridPacket);
  return {grid.x, grid.y, grid.theta, head.x};
}

/// Moves the head direction cells by turn and climb, and the grid cells by the climb and by the
/// horizontal motion along the heading of the head direction cells.
void NeuroslamCells::integrate(const Motion& motion) {
  State& state = *state_;
  const Eigen::Isometry3d before = state.T_start_camera;
  state.T_start_camera = normalised(before * motion.T_previous_current);
  const Eigen::Vector3d step = before.linear() * motion.T_previous_current.translation();
  const double turned = wrapAngle(toPlanar(state.T_start_camera).theta - toPlanar(before).theta);
  const double climbed = -step.y() / parameters_.cell_height;
  const double heading = radians(state.estimate.heading) - toPlanar(before).theta;
  const PlanarPose level = compose({0, 0, heading}, {step.z(), -step.x(), 0});
  const double cell = parameters_.cell_size;
  state.grid.shift(level.x / cell, level.y / cell, climbed);
  state.head.shift(headingCells(turned), climbed, 0);
}

void NeuroslamCells::inject(const HabituatingViews<ConjunctivePlace>::Injection& injection,
                            double turned) {
  const ConjunctivePlace& place = injection.place;
  const auto cell = [](double along) { return static_cast<int>(std::lround(along)); };
  state_->grid.add(cell(place.x), cell(place.y), cell(place.height),
                   static_cast<float>(kGridInjectedEnergy * injection.energy));
  state_->head.add(cell(place.heading + turned), cell(place.height), 0,
                   static_cast<float>(kHeadInjectedEnergy * injection.energy));
}

Status NeuroslamCells::step(const Motion& motion, const PlaceObservation& observation,
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
    ConjunctivePlace straight = estimate();
    straight.heading -= turned;
    const auto injection = state.views.see(observation.template_id, straight);
    if (injection) inject(*injection, turned);
  }
  state.head.attract(head_excitation_, head_inhibition_, static_cast<float>(kHeadGlobalInhibition));
  state.grid.attract(grid_excitation_, grid_inhibition_, static_cast<float>(kGridGlobalInhibition));
  state.estimate = estimate();
  if (seen) {
    ConjunctivePlace straight = state.estimate;
    straight.heading -= turned;
    decision.template_id = observation.template_id;
    decision.action = state.experiences.decide(straight, observation.template_id);
    decision.relative_yaw = observation.relative_yaw;
  } else if (state.experiences.current() < 0) {
    decision.action = state.experiences.createFirst(state.estimate);
  }
  decision.experience = state.experiences.current();
  decision.heading = wrapPeriod(radians(state.estimate.heading), kTurn);
  return Status::ok();
}

void NeuroslamCells::arrays(std::vector<NamedArray>& arrays) const {
  const int side = parameters_.side;
  const int headings = parameters_.headings;
  const auto layer = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  const std::span<const float> head = state_->head.values();
  const std::span<const float> grid = state_->grid.values();
  std::vector<float> layers(head.begin(), head.end());
  std::vector<float> ring(static_cast<std::size_t>(headings));
  std::vector<float> sheet(layer);
  std::vector<float> height(static_cast<std::size_t>(side));
  for (std::size_t k = 0; k < head.size(); ++k) ring[k % ring.size()] += head[k];
  for (std::size_t k = 0; k < grid.size(); ++k) {
    sheet[k % layer] += grid[k];
    height[k / layer] += grid[k];
  }
  for (std::vector<float>* rates : {&layers, &ring, &sheet, &height}) scaleToPeak(*rates);
  const ConjunctivePlace& e = state_->estimate;
  arrays.push_back({"hd.activity", {headings}, std::move(ring)});
  arrays.push_back({"hd.layers", {side, headings}, std::move(layers)});
  arrays.push_back({"grid.activity", {side, side}, std::move(sheet)});
  arrays.push_back({"grid.height", {side}, std::move(height)});
  arrays.push_back({"pose.estimate",
                    {4},
                    {static_cast<float>(e.x), static_cast<float>(e.y), static_cast<float>(e.height),
                     static_cast<float>(e.heading)}});
}

Status NeuroslamCells::describe(std::vector<ArrayInfo>& arrays) const {
  const Parameters& p = parameters_;
  const ArrayAxis heading = {"heading", "rad", 0, kTurn / p.headings, kTurn, {}};
  const ArrayAxis height = {"height", "m", 0, p.cell_height, p.side * p.cell_height, {}};
  const auto along = [&](const char* name) {
    return ArrayAxis{name, "m", 0, p.cell_size, p.side * p.cell_size, {}};
  };
  const auto activity = [&](const char* name, const char* what, std::vector<ArrayAxis> axes) {
    arrays.push_back({name, ArrayKind::Activity, "", what, "", std::move(axes)});
  };
  activity("hd.activity", "sums of all head direction cells of one heading, 1 at the most",
           {heading});
  activity("hd.layers", "head direction cells, 1 at the most", {height, heading});
  activity("grid.activity", "sums of all grid cells of one position, 1 at the most",
           {along("y"), along("x")});
  activity("grid.height", "sums of all grid cells of one height, 1 at the most", {height});
  arrays.push_back({"pose.estimate",
                    ArrayKind::Values,
                    "cells",
                    "centres of the strongest activity",
                    "",
                    {{"component", "", 0, 1, 0, {"x", "y", "height", "heading"}}}});
  return Status::ok();
}

}  // namespace tolman::neuroslam_cells
