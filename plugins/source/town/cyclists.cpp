// SPDX-License-Identifier: BSD-3-Clause
#include "cyclists.hpp"

#include <cmath>

#include "noise.hpp"
#include "people.hpp"
#include "tolman/geometry.hpp"
#include "traffic.hpp"

namespace tolman::town {

Cyclists::Cyclists(const CameraRoute& route, const StreetPlan& plan, double cyclists_per_km,
                   std::uint32_t seed)
    : plan_(&plan),
      lanes_({Lane(route, StreetPlan::kLaneOffset - kOver),
              Lane(route, StreetPlan::kLaneOffset + kOver)}) {
  if (lanes_[0].isEmpty() || lanes_[1].isEmpty()) return;
  const auto count =
      static_cast<std::uint32_t>(std::lround(cyclists_per_km * lanes_[0].length() / 1000));
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t own = hash(seed, i);
    Cyclist cyclist;
    cyclist.comes = i % 2 == 1;
    cyclist.start = lanes_[cyclist.comes ? 1 : 0].length() *
                    (i + static_cast<double>(unit(hash(own, 1)))) / count;
    cyclist.speed = 3.5 + 2.5 * static_cast<double>(unit(hash(own, 2)));
    cyclists_.push_back(cyclist);
  }
}

Cyclists::Posture Cyclists::at(std::size_t index, double seconds) const {
  constexpr double kMetresPerTurn = 4.5;  // m per turn of the pedals
  const Cyclist& cyclist = cyclists_[index];
  const Lane& lane = lanes_[cyclist.comes ? 1 : 0];
  const double driven = cyclist.speed * seconds;
  const double s = wrapPeriod(cyclist.start + (cyclist.comes ? -driven : driven), lane.length());
  const Lane::Position place = lane.at(s);
  const double turns = wrapPeriod(driven / kMetresPerTurn, 1.0);
  // Pedals turn forwards: clockwise seen from the right.
  const int phase = kPedalPhases - 1 - static_cast<int>(turns * kPedalPhases);
  return {onRoad(*plan_, place, cyclist.comes), phase};
}

}  // namespace tolman::town
