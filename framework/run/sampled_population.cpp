// SPDX-License-Identifier: BSD-3-Clause
#include "run/sampled_population.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "evaluation/population_code.hpp"

namespace tolman::run {
namespace {

using evaluation::unitsAlong;

constexpr std::size_t kMostFrames = 4000;  // halved when reached
constexpr std::size_t kUnitsAlongAxis = 6;
constexpr std::size_t kMostRingUnits = 72;

/// Evenly of `count`, at most `most`.
std::vector<std::size_t> evenly(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t size = std::min(count, most);
  for (std::size_t i = 0; i < size; ++i) chosen.push_back((2 * i + 1) * count / (2 * size));
  return chosen;
}

}  // namespace

StampedPoses stampedPosesOf(const evaluation::Trajectory& trajectory) {
  StampedPoses poses;
  for (const auto& pose : trajectory) {
    poses[pose.frame] = {toPlanar(pose.T_world_camera), pose.stamp_ns};
  }
  return poses;
}

bool SampledPopulation::accepts(const ArrayInfo& info) {
  if (info.kind != ArrayKind::Activity || info.axes.empty() || info.axes.size() > 2) return false;
  const auto periodic = [](const ArrayAxis& axis) {
    return axis.period > 0 && unitsAlong(axis) > 2;
  };
  if (!std::ranges::all_of(info.axes, periodic)) return false;
  if (info.axes.size() == 2) return true;
  const ArrayAxis& axis = info.axes[0];
  const double turn = axis.unit == "deg" ? 360 : 2 * std::numbers::pi;
  return (axis.unit == "deg" || axis.unit == "rad") && std::abs(axis.period - turn) < 1e-6 * turn;
}

SampledPopulation::SampledPopulation(const ArrayInfo& info) : info_(info) {
  if (isRing()) {
    chosen_ = evenly(size(), kMostRingUnits);
    return;
  }
  for (const std::size_t row : evenly(unitsAlong(info.axes[0]), kUnitsAlongAxis)) {
    for (const std::size_t column : evenly(unitsAlong(info.axes[1]), kUnitsAlongAxis)) {
      chosen_.push_back(row * unitsAlong(info.axes[1]) + column);
    }
  }
}

std::size_t SampledPopulation::size() const {
  return unitsAlong(info_.axes[0]) * (isRing() ? 1 : unitsAlong(info_.axes[1]));
}

void SampledPopulation::add(std::int64_t frame, std::span<const float> activity) {
  if (activity.size() != size() || seen_++ % stride_ != 0) return;
  frames_.push_back(frame);
  for (const std::size_t unit : chosen_) rates_.push_back(activity[unit]);
  if (frames_.size() >= kMostFrames) dropEverySecond();
}

void SampledPopulation::dropEverySecond() {
  const std::size_t width = chosen_.size();
  const std::size_t kept = (frames_.size() + 1) / 2;
  for (std::size_t i = 0; i < kept; ++i) {
    frames_[i] = frames_[2 * i];
    for (std::size_t k = 0; k < width; ++k) rates_[i * width + k] = rates_[2 * i * width + k];
  }
  frames_.resize(kept);
  rates_.resize(kept * width);
  stride_ *= 2;
}

evaluation::RecordedUnits SampledPopulation::units(const StampedPoses& poses) const {
  evaluation::RecordedUnits units{{}, std::vector<std::vector<float>>(chosen_.size())};
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    const auto stamped = poses.find(frames_[i]);
    if (stamped == poses.end()) continue;
    const PlanarPose& pose = stamped->second.pose;
    units.walk.push_back({{-pose.y, pose.x}, pose.theta, 0});
    for (std::size_t k = 0; k < chosen_.size(); ++k) {
      units.rates[k].push_back(rates_[i * chosen_.size() + k]);
    }
  }
  return units;
}

double SampledPopulation::seconds(const StampedPoses& poses) const {
  std::int64_t first = -1;
  std::int64_t last = -1;
  for (const std::int64_t frame : frames_) {
    const auto stamped = poses.find(frame);
    if (stamped == poses.end()) continue;
    if (first < 0) first = stamped->second.stamp_ns;
    last = stamped->second.stamp_ns;
  }
  return 1e-9 * static_cast<double>(last - first);
}

}  // namespace tolman::run
