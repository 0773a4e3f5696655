// SPDX-License-Identifier: BSD-3-Clause
// Cars in the side streets of junctions: each drives up to the junction, waits until the camera has
// passed, and crosses the camera's path.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lane.hpp"
#include "street_plan.hpp"
#include "vec3.hpp"

namespace tolman::town {

class CrossingTraffic {
 public:
  /// `share` of the side streets have a car.
  CrossingTraffic(const CameraRoute& route, const StreetPlan& plan, double share,
                  std::uint32_t seed);

  std::size_t size() const { return cars_.size(); }
  /// Car `index`, `seconds` after the first pose; empty long before and after the camera passes.
  std::optional<Placement> at(std::size_t index, double seconds) const;

 private:
  struct Car {
    bool comes = false;  ///< on the oncoming lane of the route, against its direction
    double stop_s = 0;   ///< m along that lane
    double arrives = 0;  ///< s, at the stop
    double leaves = 0;   ///< s
  };
  struct Junction {
    double s = 0;        ///< m along the camera's path
    double other_s = 0;  ///< m along the path, of the pass through the side street
  };
  std::vector<Junction> junctions() const;
  /// A car in the side street before (`comes`: behind) the junction, if the camera is not there.
  std::optional<Car> carAt(const Junction& junction, bool comes, double passes_at) const;

  const StreetPlan* plan_;
  Lane way_;       ///< the camera's
  Lane oncoming_;  ///< to its left
  std::vector<Car> cars_;
};

}  // namespace tolman::town
