// SPDX-License-Identifier: BSD-3-Clause
#include "report/cell_history.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tolman::report {
namespace {

constexpr std::size_t kMostOthers = 240;  // more columns than this cannot be told apart

bool isPopulation(const ArrayInfo& info, std::size_t dimensions) {
  return info.kind == ArrayKind::Activity && info.axes.size() == dimensions;
}

void add(PopulationHistory& history, std::int64_t frame, NamedArray&& array) {
  if (history.empty()) history.shape = array.shape;
  if (array.shape != history.shape) return;
  history.frames.push_back(frame);
  history.activity.push_back(std::move(array.values));
}

template <class T>
void dropEverySecond(std::vector<T>& list) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < list.size(); i += 2) list[kept++] = std::move(list[i]);
  list.resize(kept);
}

/// Keeps every stride-th array; doubles the stride when there are too many.
void addThinned(PopulationHistory& history, std::int64_t frame, NamedArray&& array) {
  if (history.seen++ % history.stride != 0) return;
  add(history, frame, std::move(array));
  if (history.frames.size() <= kMostOthers) return;
  dropEverySecond(history.frames);
  dropEverySecond(history.activity);
  history.stride *= 2;
}

/// The first populations of one and two dimensions are those that figures measure.
void chooseArrays(CellHistory& cells, const std::vector<ArrayInfo>& infos) {
  for (const ArrayInfo& info : infos) {
    const bool ring = isPopulation(info, 1) && info.axes[0].period > 0;
    if (ring && cells.ring.info.name.empty()) cells.ring.info = info;
    if (isPopulation(info, 2) && cells.sheet.info.name.empty()) cells.sheet.info = info;
  }
}

/// Plugins built for SDK 0.1 have no descriptions. Their first arrays of one and two dimensions
/// named "*.activity" were rings and sheets with unit 0 at 0.
void chooseUndescribed(CellHistory& cells, const NamedArray& array) {
  if (!array.name.ends_with(".activity")) return;
  const auto size = [&](std::size_t i) { return static_cast<double>(array.shape[i]); };
  constexpr double kTurn = 2 * std::numbers::pi;
  if (array.shape.size() == 1 && cells.ring.info.name.empty()) {
    cells.ring.info = {array.name, ArrayKind::Activity, "", "", "", {}};
    cells.ring.info.axes = {{"heading", "rad", 0, kTurn / size(0), kTurn, {}}};
  } else if (array.shape.size() == 2 && cells.sheet.info.name.empty()) {
    cells.sheet.info = {array.name, ArrayKind::Activity, "", "", "", {}};
    cells.sheet.info.axes = {{"row", "", 0, 1, size(0), {}}, {"column", "", 0, 1, size(1), {}}};
  }
}

PopulationHistory& otherOf(CellHistory& cells, const std::string& name,
                           const std::vector<ArrayInfo>& infos) {
  for (PopulationHistory& other : cells.others) {
    if (other.info.name == name) return other;
  }
  PopulationHistory& other = cells.others.emplace_back();
  const auto info = std::ranges::find(infos, name, &ArrayInfo::name);
  if (info != infos.end()) other.info = *info;
  other.info.name = name;
  return other;
}

}  // namespace

Result<CellHistory> readCells(const record::RunReader& reader,
                              const std::vector<Decision>& decisions) {
  const auto infos = reader.arrayInfos();
  if (!infos.isOk()) return infos.status();
  CellHistory cells;
  chooseArrays(cells, infos.value());
  for (const Decision& decision : decisions) {
    auto arrays = reader.arrays(decision.frame, "cells");
    if (!arrays.isOk()) return arrays.status();
    for (NamedArray& array : arrays.value()) {
      if (array.values.empty()) continue;
      if (infos.value().empty()) chooseUndescribed(cells, array);
      if (array.name == cells.ring.info.name && array.shape.size() == 1) {
        add(cells.ring, decision.frame, std::move(array));
      } else if (array.name == cells.sheet.info.name && array.shape.size() == 2) {
        add(cells.sheet, decision.frame, std::move(array));
      } else {
        PopulationHistory& other = otherOf(cells, array.name, infos.value());
        addThinned(other, decision.frame, std::move(array));
      }
    }
  }
  return cells;
}

double axisValue(const ArrayAxis& axis, std::size_t i) {
  const double value = axis.first + axis.step * static_cast<double>(i);
  return axis.period > 0 ? value - axis.period * std::floor(value / axis.period) : value;
}

double axisAngle(const ArrayAxis& axis, std::size_t i) {
  return axisValue(axis, i) * (axis.unit == "deg" ? std::numbers::pi / 180 : 1);
}

}  // namespace tolman::report
