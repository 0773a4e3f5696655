// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/cell_descriptions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "evaluation/population_code.hpp"

namespace tolman::evaluation {
namespace {

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
