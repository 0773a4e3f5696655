// SPDX-License-Identifier: BSD-3-Clause
// Light and season at each frame of the drive.
#pragma once

#include <string>
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
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::vector<Condition> conditions_;  ///< of each frame
  std::vector<Light> lights_;          ///< of each frame, before changes are spread
  std::vector<double> driven_;         ///< m, until each frame
  std::vector<std::string> warnings_;  ///< of entries that hold nowhere
};

}  // namespace tolman::town
