// SPDX-License-Identifier: BSD-3-Clause
// A car park of five identical floors at the end of a street, with ramps between them.
#pragma once

#include "plots.hpp"
#include "route_shapes.hpp"
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

}  // namespace tolman::town
