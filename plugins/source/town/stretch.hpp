// SPDX-License-Identifier: BSD-3-Clause
// One side of a street for some tens of metres, of one kind of neighbourhood, with its houses,
// gardens, trees, parked cars and street furniture.
#pragma once

#include <cstdint>

#include "furniture.hpp"
#include "plots.hpp"
#include "prototypes.hpp"
#include "street_plan.hpp"
#include "tolman/context.hpp"
#include "world.hpp"

namespace tolman::town {

struct Stretch {
  const StreetSection* section = nullptr;
  bool left = false;
  double begin = 0;  ///< m along the section
  double end = 0;
  std::uint32_t seed = 0;
  double density = 1;
};

class StretchBuilder {
 public:
  StretchBuilder(World& world, const StreetPlan& plan, const Prototypes& prototypes, PlotBook& book)
      : world_(world), plan_(plan), prototypes_(prototypes), book_(book), random_(0) {}

  void fill(const Stretch& stretch);

 private:
  struct HouseKind;
  /// A plot whose middle is `over` m from the centreline, at s along the section.
  Plot plotAt(double s, double over, double half_length, double half_depth) const;
  double groundAt(const Plot& plot) const;
  Stand standAt(double s, double over);
  double draw(double low, double high) { return random_.uniform(low, high); }
  bool chance(double probability) { return random_.uniform() < probability; }

  void houses(const HouseKind& kind);
  void backHouses();
  void frontGarden(double s, double half_length, double garden);
  void streetTrees();
  void verge();
  void gardenTrees(double count, double nearest);
  void parkedCars();
  void lampsAndSigns();
  void instance(const std::vector<std::uint32_t>& kinds, const Plot& plot, double yaw,
                double scale);

  World& world_;
  const StreetPlan& plan_;
  const Prototypes& prototypes_;
  PlotBook& book_;
  Stretch stretch_;
  RandomStream random_;
};

}  // namespace tolman::town
