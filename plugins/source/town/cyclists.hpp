// SPDX-License-Identifier: BSD-3-Clause
// Cyclists at both edges of the road: positions and postures as a function of time.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lane.hpp"
#include "street_plan.hpp"
#include "vec3.hpp"

namespace tolman::town {

class Cyclists {
 public:
  /// m from the centreline of the street
  static constexpr double kOver = StreetPlan::kRoadHalfWidth - 0.45;

  Cyclists(const CameraRoute& route, const StreetPlan& plan, double cyclists_per_km,
           std::uint32_t seed);

  std::size_t size() const { return cyclists_.size(); }
  struct Posture {
    Placement placement;
    int phase = 0;  ///< of the pedals, below kPedalPhases
  };
  /// Cyclist `index`, `seconds` after the first pose.
  Posture at(std::size_t index, double seconds) const;

 private:
  struct Cyclist {
    bool comes = false;  ///< against the route's direction
    double start = 0;    ///< m along the lane
    double speed = 0;    ///< m/s
  };

  const StreetPlan* plan_;
  std::array<Lane, 2> lanes_;  ///< along the route on the right, against it on the left
  std::vector<Cyclist> cyclists_;
};

}  // namespace tolman::town
