// SPDX-License-Identifier: BSD-3-Clause
// Light and season at each frame of the drive.
#pragma once

#include <vector>

#include "conditions.hpp"
#include "light.hpp"
#include "route.hpp"
#include "town_parameters.hpp"

namespace tolman::town {

class ConditionSchedule {
 public:
  static Result<ConditionSchedule> make(const TownParameters& parameters, const CameraRoute& route);

  /// Changes of light are spread over 20 m of driving, so that odometry does not lose track.
  Light lightAt(std::size_t frame) const;
  const Condition& at(std::size_t frame) const { return conditions_[frame]; }
  bool anyBare() const;
  bool anyExchanged() const;

 private:
  std::vector<Condition> conditions_;  ///< of each frame
  std::vector<Light> lights_;          ///< of each frame, before changes are spread
  std::vector<double> driven_;         ///< m, until each frame
};

}  // namespace tolman::town
