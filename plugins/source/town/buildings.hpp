// SPDX-License-Identifier: BSD-3-Clause
// Buildings that routes lead through: a car park of five identical floors at the end of a street,
// and a furnished hall without windows, round whose tables a camera is carried by hand.
#pragma once

#include "lane_path.hpp"
#include "route.hpp"
#include "world.hpp"

namespace tolman::town {

/// Axes of the building: those of the town with the origin on the floor where the southern aisle
/// meets the western one, x across and y away from the street. Aisles are one-way, clockwise seen
/// from above: north on the western one (x = 0), south on the eastern one. Ramps lie beside them
/// and rise to the south: the western one is driven down, the eastern one up.
struct CarPark {
  static constexpr int kFloors = 5;
  static constexpr double kStorey = 3;       ///< m
  static constexpr double kAisleY = 60;      ///< m, Y of the building's origin in the town
  static constexpr double kLength = 44;      ///< m, from the southern to the northern aisle
  static constexpr double kRampDown = 7;     ///< m, x of the middle
  static constexpr double kRampUp = 25;      ///< m
  static constexpr double kEastAisle = 32;   ///< m
  static constexpr double kRampBegin = 9;    ///< m, y of the southern end of both ramps
  static constexpr double kRampLength = 26;  ///< m
  static constexpr double kWest = -9;        ///< m, walls
  static constexpr double kEast = 41;
  static constexpr double kSouth = -4;
  static constexpr double kNorth = 48;

  /// m above the lower end of a ramp after `along` m, 0 to kStorey; level at both ends.
  static double rampHeight(double along);
  /// The derivative.
  static double rampSlope(double along);
};

/// A point of the drive, m above the street.
struct CarParkHeight {
  double height = 0;
  double slope = 0;
};

/// In from the street, up to the uppermost floor and down again, twice, and out.
struct CarParkDrive {
  LanePath path{0};
  struct Ramp {
    double begin;   ///< m along the path
    double bottom;  ///< m, height where it begins
    bool up;
  };
  std::vector<Ramp> ramps;
  double inside_from = 0;  ///< m along the path
  double inside_to = 0;

  CarParkHeight at(double s) const;
};
CarParkDrive carParkDrive();

/// Ground plan, and the building with pillars and parked cars; `floor` is the Z of the lowest one.
Plot carParkPlot();
void addCarPark(World& world, double floor, std::uint32_t seed);

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
