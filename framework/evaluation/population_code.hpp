// SPDX-License-Identifier: BSD-3-Clause
// Decodes the rates of populations: heading from a ring, position from grid modules.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tolman/fields.hpp"

namespace tolman::evaluation {

/// Number of units along a periodic axis; 0 without a step.
std::size_t unitsAlong(const ArrayAxis& axis);

/// Direction of the population vector of units along one periodic axis (Georgopoulos, Schwartz,
/// Kettner 1986), in the unit of the axis, in [0, period). None if there is no activity, or the
/// same activity everywhere.
std::optional<double> populationVector(std::span<const double> rates, const ArrayAxis& axis);

/// Position modulo a period, decoded from one grid module by its population vectors.
struct ModulePhase {
  Eigen::Vector2d phase = Eigen::Vector2d::Zero();  ///< x and y
  double period = 1;
};
/// Why a population gives no position in metres; empty for two axes that are named x or y, have the
/// unit m and equal periods.
std::string noPositionReason(const ArrayInfo& sheet);
/// `sheet` must have an empty noPositionReason(). None where the activity has no phase.
std::optional<ModulePhase> modulePhase(std::span<const float> rates, const ArrayInfo& sheet);

/// Decodes positions (m) from the phases of grid modules, and compares them with true positions.
class PositionDecoder {
 public:
  /// Positions are decoded within [low, high]. `modules` are the phases at `position`: they define
  /// the origin of the code.
  PositionDecoder(const std::vector<ModulePhase>& modules, const Eigen::Vector2d& position,
                  const Eigen::Vector2d& low, const Eigen::Vector2d& high);

  /// The position that fits the phases of all modules best. The errors of a phase are assumed to be
  /// proportional to the period (Fiete, Burak, Brookings 2008).
  Eigen::Vector2d decode(const std::vector<ModulePhase>& modules) const;
  /// Distance from `position` to the decoded one, m; modulo the period if there is only one module.
  double error(const std::vector<ModulePhase>& modules, const Eigen::Vector2d& position) const;

 private:
  std::vector<ModulePhase> origin_;
  Eigen::Vector2d low_;
  Eigen::Vector2d high_;
};

}  // namespace tolman::evaluation
