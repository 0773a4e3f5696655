// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/recorded_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "evaluation/population_code.hpp"

namespace tolman::evaluation {
namespace {

constexpr double kFarthest = 1e7;             // m
constexpr std::size_t kMaxOthers = 240;       // frames; a figure cannot show more columns
constexpr std::size_t kMaxFrames = 5000;      // of a population; beyond it every second is dropped
constexpr std::size_t kMaxValues = 10000000;  // of a population, all frames together
constexpr std::size_t kMaxRingUnits = 72;

/// At most `most` indices below `count`, evenly spaced.
std::vector<std::size_t> evenly(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t size = std::min(count, most);
  for (std::size_t i = 0; i < size; ++i) chosen.push_back((2 * i + 1) * count / (2 * size));
  return chosen;
}

template <class T>
void dropEverySecond(std::vector<T>& list) {
  for (std::size_t i = 2; i < list.size(); i += 2) list[i / 2] = std::move(list[i]);
  list.resize((list.size() + 1) / 2);
}

bool isPopulation(const ArrayInfo& info) {
  const auto periodic = [](const ArrayAxis& axis) {
    return axis.period > 0 && unitsAlong(axis) > 2;
  };
  return info.kind == ArrayKind::Activity && std::ranges::all_of(info.axes, periodic);
}

bool isAngle(const ArrayAxis& axis) {
  const double turn = axis.unit == "deg" ? 360 : 2 * std::numbers::pi;
  return (axis.unit == "deg" || axis.unit == "rad") && std::abs(axis.period - turn) < 1e-6 * turn;
}

constexpr double kTurnDeg = 360;
constexpr double kTurnRad = 2 * std::numbers::pi;

/// Whether the period is a turn in the other unit of angles than that of the axis.
bool isOtherTurn(const ArrayAxis& axis) {
  const double other = axis.unit == "deg" ? kTurnRad : axis.unit == "rad" ? kTurnDeg : 0;
  return other > 0 && std::abs(axis.period - other) < 1e-6 * other;
}

/// `size`: of the recorded array along this axis. An axis without a period has any length.
std::string contradictionOf(const ArrayAxis& axis, int size) {
  if (axis.period <= 0) return "";
  if (isOtherTurn(axis)) {
    return fmt::format("has a period of {:.4g} {}; a turn is 360 deg or 2 pi rad", axis.period,
                       axis.unit);
  }
  if (axis.step <= 0) {
    return fmt::format("has steps of {:.4g} {}; those of a periodic axis are above 0", axis.step,
                       axis.unit);
  }
  const std::size_t units = unitsAlong(axis);
  if (units == static_cast<std::size_t>(size)) return "";
  return fmt::format("has {} units; a period of {:.4g} {} in steps of {:.4g} is {}", size,
                     axis.period, axis.unit, axis.step, units);
}

}  // namespace

StampedPoses stampedPosesOf(const Trajectory& trajectory) {
  StampedPoses poses;
  for (const auto& pose : trajectory) {
    if (!(pose.T_world_camera.translation().cwiseAbs().maxCoeff() < kFarthest)) continue;
    poses[pose.frame] = {toPlanar(pose.T_world_camera), pose.stamp_ns};
  }
  return poses;
}

void PopulationHistory::add(std::int64_t frame, NamedArray&& array, std::size_t most) {
  if (!given) given = array.shape;
  if (array.values.empty()) return;
  if (shape.empty()) shape = array.shape;
  if (array.shape != shape || seen++ % stride != 0) return;
  frames.push_back(frame);
  activity.push_back(std::move(array.values));
  if (frames.size() <= most) return;
  dropEverySecond(frames);
  dropEverySecond(activity);
  stride *= 2;
}

CellHistory::CellHistory(const std::vector<ArrayInfo>& infos) {
  for (const ArrayInfo& info : infos) {
    const bool ring = isPopulation(info) && info.axes.size() == 1 && isAngle(info.axes[0]);
    const bool sheet = isPopulation(info) && info.axes.size() == 2;
    PopulationHistory& history = (ring ? rings : sheet ? sheets : others).emplace_back();
    history.info = info;
    if (!ring && !sheet) continue;
    for (const ArrayAxis& axis : info.axes) {
      history.shape.push_back(static_cast<int>(unitsAlong(axis)));
    }
  }
}

void CellHistory::add(std::int64_t frame, NamedArray&& array) {
  for (auto* list : {&rings, &sheets, &others}) {
    const auto known = std::ranges::find(
        *list, array.name, [](const PopulationHistory& history) { return history.info.name; });
    if (known == list->end()) continue;
    const std::size_t size = std::max<std::size_t>(array.values.size(), 1);
    const std::size_t most = std::clamp(kMaxValues / size, kMaxOthers, kMaxFrames);
    known->add(frame, std::move(array), list == &others ? kMaxOthers : most);
    return;
  }
  others.emplace_back().info.name = array.name;
  others.back().add(frame, std::move(array), kMaxOthers);
}

void CellHistory::dropEmpty() {
  for (auto* list : {&rings, &sheets, &others}) {
    std::erase_if(*list, [](const PopulationHistory& history) { return history.frames.empty(); });
  }
}

std::string CellHistory::whyUnscored() const {
  std::string first;
  bool any_given = false;
  for (const auto* list : {&rings, &sheets, &others}) {
    for (const PopulationHistory& history : *list) {
      if (list != &others && !history.frames.empty()) return "";
      any_given = any_given || history.given;
      if (first.empty()) first = contradictionOf(history);
    }
  }
  return any_given ? first : "";
}

std::vector<std::size_t> measuredUnits(const PopulationHistory& population) {
  const auto size = [&](std::size_t axis) {
    return static_cast<std::size_t>(population.shape[axis]);
  };
  if (population.shape.size() == 1) return evenly(size(0), kMaxRingUnits);
  std::vector<std::size_t> chosen;
  for (const std::size_t row : evenly(size(0), kMaxUnitsAlongAxis)) {
    for (const std::size_t column : evenly(size(1), kMaxUnitsAlongAxis)) {
      chosen.push_back(row * size(1) + column);
    }
  }
  return chosen;
}

RecordedUnits unitsAt(const PopulationHistory& population, const StampedPoses& poses,
                      const std::vector<std::size_t>& chosen) {
  RecordedUnits units{{}, std::vector<std::vector<float>>(chosen.size())};
  std::int64_t first = -1;
  for (std::size_t i = 0; i < population.frames.size(); ++i) {
    const auto stamped = poses.find(population.frames[i]);
    if (stamped == poses.end()) continue;
    const auto& [pose, stamp_ns] = stamped->second;
    if (units.walk.empty()) first = stamp_ns;
    units.seconds = 1e-9 * static_cast<double>(stamp_ns - first);
    units.walk.push_back({{-pose.y, pose.x}, pose.theta, 0});
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      units.rates[k].push_back(population.activity[i][chosen[k]]);
    }
  }
  return units;
}

double periodInMetres(const PopulationHistory& sheet) {
  const ArrayAxis& axis = sheet.info.axes[0];
  return axis.unit == "m" ? axis.period : 0;
}

double axisValue(const ArrayAxis& axis, std::size_t i) {
  const double value = axis.first + axis.step * static_cast<double>(i);
  return axis.period > 0 ? wrapPeriod(value, axis.period) : value;
}

double axisAngle(const ArrayAxis& axis, std::size_t i) {
  return axisValue(axis, i) * (axis.unit == "deg" ? std::numbers::pi / 180 : 1);
}

std::string contradictionOf(const PopulationHistory& population) {
  const ArrayInfo& info = population.info;
  if (info.kind != ArrayKind::Activity || info.axes.empty()) return "";
  if (!population.given)
    return fmt::format("array '{}' is described and was never given", info.name);
  const std::vector<int>& shape = *population.given;
  if (shape.size() != info.axes.size()) {
    return fmt::format("array '{}' has {} axes and is described with {}", info.name, shape.size(),
                       info.axes.size());
  }
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const std::string problem = contradictionOf(info.axes[i], shape[i]);
    if (problem.empty()) continue;
    return fmt::format("axis '{}' of array '{}' {}", info.axes[i].name, info.name, problem);
  }
  return "";
}

}  // namespace tolman::evaluation
