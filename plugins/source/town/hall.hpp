// SPDX-License-Identifier: BSD-3-Clause
// A furnished hall without windows, and a camera that is carried round its tables by hand.
#pragma once

#include "route.hpp"
#include "world.hpp"

namespace tolman::town {

/// Dimensions in town axes; the walk begins at the origin, along Y.
struct Hall {
  static constexpr double kWest = -8.6;  ///< m, walls
  static constexpr double kEast = 2.6;
  static constexpr double kSouth = -7;
  static constexpr double kNorth = 7;
  static constexpr double kCeiling = 2.4;    ///< m above the first camera
  static constexpr double kMiddleX = -3;     ///< m, centre of the ellipse of the walk
  static constexpr double kHalfAcross = 3;   ///< m, along X
  static constexpr double kHalfAlong = 4.5;  ///< m, along Y
  static constexpr double kRounds = 2.15;
};

/// A walk counter-clockwise at options.speed, at most 0.8 m/s. The height of the hand varies by
/// 0.25 m and with the steps. The camera turns by up to 20 degrees to the sides, 12 up and down,
/// and 10 of roll. All of these differ between the two rounds.
CameraRoute hallWalk(const RouteOptions& options);

/// The route of the town's street, which is not visible from the hall: as many poses as the walk.
CameraRoute streetBesideHall(const CameraRoute& walk);

Plot hallPlot();
/// Walls, tables, shelves, chests, pillars and posters; `floor` is the Z of the floor, m.
void addHall(World& world, double floor, std::uint32_t seed);

}  // namespace tolman::town
