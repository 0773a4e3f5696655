// SPDX-License-Identifier: BSD-3-Clause
// What a population says by its rates: heading from a ring, position from grid modules.
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
/// Kettner 1986), in the unit of the axis, in [0, period). None where it has no direction: no
/// activity, or the same everywhere.
std::optional<double> populationVector(std::span<const double> rates, const ArrayAxis& axis);

/// Position modulo a period, as one grid module tells it by its population vectors.
struct ModulePhase {
  Eigen::Vector2d phase = Eigen::Vector2d::Zero();  ///< x and y
  double period = 1;
};
/// Why a population tells no position in metres; empty where it does: a sheet with equal periods
/// along the axes x and y, in m.
std::string noPositionReason(const ArrayInfo& sheet);
/// For a sheet without such a reason. None where the activity has no phase.
std::optional<ModulePhase> modulePhase(std::span<const float> rates, const ArrayInfo& sheet);

/// Decodes positions from the phases of grid modules, and compares them with where the robot was.
class PositionDecoder {
 public:
  /// The robot is known to be within [low, high]. The first phases are those at `position`: they
  /// tie the origin of the code.
  PositionDecoder(const std::vector<ModulePhase>& modules, const Eigen::Vector2d& position,
                  const Eigen::Vector2d& low, const Eigen::Vector2d& high);

  /// The position that explains the phases of all modules best; errors of a phase are in proportion
  /// to the period (Fiete, Burak, Brookings 2008).
  Eigen::Vector2d decode(const std::vector<ModulePhase>& modules) const;
  /// Distance from `position` to the decoded one; for a single module modulo its period, as it
  /// cannot tell more.
  double error(const std::vector<ModulePhase>& modules, const Eigen::Vector2d& position) const;

 private:
  std::vector<ModulePhase> origin_;
  Eigen::Vector2d low_;
  Eigen::Vector2d high_;
};

}  // namespace tolman::evaluation
