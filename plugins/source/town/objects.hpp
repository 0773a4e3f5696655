// SPDX-License-Identifier: BSD-3-Clause
// The makers of everything that stands in the town.
#pragma once

#include <cstdint>
#include <vector>

#include "world.hpp"

namespace tolman::town {

bool overlap(const Plot& a, const Plot& b);

/// Keeps plots from overlapping.
class PlotBook {
 public:
  explicit PlotBook(const StreetPlan& plan) : plan_(&plan) {}

  /// Registers the plot if it is free and at least `clearance` m from every centreline. Its half
  /// dimensions must be below 35 m.
  bool enter(const Plot& plot, double clearance);

 private:
  bool clearOfStreets(const Plot& plot, double clearance) const;

  const StreetPlan* plan_;
  std::vector<Plot> plots_;
  PointGrid grid_{50};  // m; so large that plots that overlap are in neighbouring cells
};

enum class RoofShape : std::uint8_t { AlongStreet, ToStreet, Flat };

struct House {
  Plot plot;          ///< its ground plan; `axis` is parallel to the street
  double ground = 0;  ///< m, Z of the land at its centre
  int storeys = 2;
  RoofShape roof = RoofShape::AlongStreet;
  std::uint32_t seed = 0;
};

void addHouse(World& world, const House& house);

/// Place and orientation of an object beside the street.
struct Stand {
  Vec3 foot;
  Vec3 along;   ///< unit vector of the street
  Vec3 inward;  ///< unit vector towards the middle of the street
  std::uint32_t seed = 0;
};

void addLamp(World& world, const Stand& stand);
void addSign(World& world, const Stand& stand);
void addPoster(World& world, const Stand& stand);

/// A fence or a hedge over the plot's length; a hedge is as deep as the plot.
void addFence(World& world, const Plot& plot, double ground, std::uint32_t seed);
void addHedge(World& world, const Plot& plot, double ground, std::uint32_t seed);

/// The broken line in the middle of each section, without junctions.
void addLaneMarkings(World& world, const StreetPlan& plan, std::uint32_t seed);

/// Identical rails on posts on both sides of the streets, without junctions.
void addGuardRails(World& world, const StreetPlan& plan);

/// A ring of wooded hills that closes the view.
void addHorizon(World& world, const StreetPlan& plan, std::uint32_t seed);

/// Indices into the table of surfaces.
struct GroundSurfaces {
  std::uint32_t road = 0;
  std::uint32_t kerb = 0;
  std::uint32_t land = 0;  ///< pavement, verge, grass: the material depends on the distance
};

/// A grid of 1 m cells within kFarthest of the streets, cut along the kerb (marching squares on
/// distance() = kRoadHalfWidth): the road at height(), the land kKerbHeight higher, and a vertical
/// kerb between them. Around it is a coarse grid up to `horizon` m, a little lower, so that there
/// is no gap.
Mesh buildGround(const StreetPlan& plan, const GroundSurfaces& surfaces, double horizon = 400);

/// Indices into World::prototypes.
struct Prototypes {
  std::vector<std::uint32_t> street_trees;  ///< slim, with a clear trunk
  std::vector<std::uint32_t> garden_trees;  ///< broad ones and conifers
  std::vector<std::uint32_t> bushes;
  std::vector<std::uint32_t> cars;  ///< facing +X, centred, wheels on Z = 0
};

Prototypes addPrototypes(World& world, std::uint32_t seed);

/// Instances of winter or of another day, at the places of usual ones; one of the two is shown.
struct Exchange {
  std::vector<std::size_t> usual;
  std::vector<std::size_t> other;
};

/// Trees and bushes without leaves, except evergreens.
Exchange addBareTrees(World& world);

/// Other cars at two of three places where one is parked.
Exchange addOtherCars(World& world, std::uint32_t seed);

}  // namespace tolman::town
