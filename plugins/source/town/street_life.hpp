// SPDX-License-Identifier: BSD-3-Clause
// Parameters of moving objects and reflections besides the traffic; all off by default.
#pragma once

#include <concepts>
#include <tuple>

#include "tolman/parameters.hpp"

namespace tolman::town {

/// Base of the source's Parameters.
struct StreetLife {
  double pedestrians = 0;
  double cyclists = 0;
  double crossing_traffic = 0;
  bool traffic_headlights = false;
  double wind = 0;
  double glass = 0;
  double puddles = 0;
};

template <std::derived_from<StreetLife> P>
constexpr auto streetLife() {
  return parameters(
      parameter<P, double>("pedestrians", &P::pedestrians)
          .range(0, 300)
          .unit("1/km")
          .doc("People on the pavements per kilometre of street; most walk, and wait where the "
               "pavement ends."),
      parameter<P, double>("cyclists", &P::cyclists)
          .range(0, 60)
          .unit("1/km")
          .doc("Cyclists at both edges of the road per kilometre of the route."),
      parameter<P, double>("crossing_traffic", &P::crossing_traffic)
          .range(0, 1)
          .doc("Share of the side streets of each junction from which a car comes, waits until "
               "the camera has passed, and drives on."),
      parameter<P, bool>("traffic_headlights", &P::traffic_headlights)
          .doc("Moving cars have their lamps on at night and light the road."),
      parameter<P, double>("wind", &P::wind)
          .range(0, 25)
          .unit("m/s")
          .doc("Speed of the wind in which trees sway and leaves flutter."),
      parameter<P, double>("glass", &P::glass)
          .range(0, 1)
          .doc("Windows of houses and cars mirror the street and the sky; 1 is clean glass."),
      parameter<P, double>("puddles", &P::puddles)
          .range(0, 1)
          .doc("Puddles on the road that mirror, as after rain; 1 covers about a quarter of it."));
}

}  // namespace tolman::town
