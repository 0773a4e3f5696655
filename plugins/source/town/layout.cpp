// SPDX-License-Identifier: BSD-3-Clause
// What stands where along the streets.
#include <algorithm>
#include <cmath>

#include "noise.hpp"
#include "objects.hpp"
#include "tolman/context.hpp"

namespace tolman::town {
namespace {

constexpr double kStretch = 45;  // m, length of one kind of place
constexpr double kFence = StreetPlan::kRoadHalfWidth + StreetPlan::kPavementWidth + 0.2;

/// Whether an axis of `a` separates the two rectangles.
bool separatedBy(const Plot& a, const Plot& b) {
  const Eigen::Vector2d offset = b.centre - a.centre;
  const auto reach = [&](const Eigen::Vector2d& direction) {
    return b.half_length * std::abs(direction.dot(b.axis)) +
           b.half_depth * std::abs(direction.dot(b.across()));
  };
  return std::abs(offset.dot(a.axis)) > a.half_length + reach(a.axis) ||
         std::abs(offset.dot(a.across())) > a.half_depth + reach(a.across());
}

/// One side of a street for some tens of metres, of one kind of neighbourhood.
struct Stretch {
  const StreetSection* section = nullptr;
  bool left = false;
  double begin = 0;  ///< m along the section
  double end = 0;
  std::uint32_t seed = 0;
  double density = 1;
};

/// Ranges of the random dimensions of houses of one kind of neighbourhood.
struct HouseKind {
  double narrow, wide;  // m along the street
  double gap;           // m between neighbours, at most
  double garden;        // m in front, at most
  double depth;         // m
  int low, high;        // storeys
  double flat;          // share of flat roofs
};

class StretchBuilder {
 public:
  StretchBuilder(World& world, const StreetPlan& plan, const Prototypes& prototypes, PlotBook& book,
                 const Stretch& stretch)
      : world_(world),
        plan_(plan),
        prototypes_(prototypes),
        book_(book),
        stretch_(stretch),
        random_(stretch.seed) {}

  void fill() {
    const double kind = random_.uniform();
    const bool trees = chance(0.45);
    const bool cars = chance(0.6);
    lampsAndSigns();
    if (cars && kind < 0.8) parkedCars();
    if (trees) streetTrees();
    if (kind < 0.35) {
      houses({9, 15, 7, 6, 10, 1, 2, 0.1});
      backHouses();
      gardenTrees(22, 9);
    } else if (kind < 0.65) {
      houses({5.5, 8.5, 0.3, 2.5, 10, 2, 3, 0.1});
      gardenTrees(18, 18);
    } else if (kind < 0.8) {
      houses({16, 27, 9, 7, 12, 3, 5, 0.7});
      backHouses();
      gardenTrees(22, 8);
    } else if (kind < 0.92) {
      gardenTrees(44, 7);  // a park
      backHouses();
    } else {
      gardenTrees(8, 15);  // open land
    }
    verge();
  }

 private:
  double draw(double low, double high) { return random_.uniform(low, high); }
  bool chance(double probability) { return random_.uniform() < probability; }
  std::uint32_t drawSeed() { return static_cast<std::uint32_t>(random_.below(1U << 31U)); }

  /// A plot whose middle is `over` m from the centreline, at s along the section. Its depth points
  /// away from the street.
  Plot plotAt(double s, double over, double half_length, double half_depth) const {
    const auto& points = stretch_.section->points;
    const long last = static_cast<long>(points.size()) - 1;
    const StreetPoint& p = points[static_cast<std::size_t>(std::clamp(std::lround(s), 0L, last))];
    Plot plot = {
        {}, stretch_.left ? p.direction : Eigen::Vector2d(-p.direction), half_length, half_depth};
    plot.centre = p.position + plot.across() * over;
    return plot;
  }
  double groundAt(const Plot& plot) const {
    return plan_.height(plot.centre.x(), plot.centre.y()) + StreetPlan::kKerbHeight;
  }
  Stand standAt(double s, double over) {
    const Plot plot = plotAt(s, over, 0.1, 0.1);
    const Eigen::Vector2d along = stretch_.left ? plot.axis : Eigen::Vector2d(-plot.axis);
    return {toVec3(plot.centre, groundAt(plot)), toVec3(along, 0), toVec3(-plot.across(), 0),
            drawSeed()};
  }
  void instance(const std::vector<std::uint32_t>& kinds, const Plot& plot, double yaw,
                double scale) {
    const double heading = std::atan2(plot.axis.y(), plot.axis.x()) + yaw;
    const std::uint32_t kind = kinds[random_.below(kinds.size())];
    const Placement placement =
        Placement::at(toVec3(plot.centre, groundAt(plot)), static_cast<float>(heading),
                      static_cast<float>(scale));
    world_.instances.push_back({kind, placement, drawSeed()});
  }

  void houses(const HouseKind& kind) {
    const double garden = draw(0.3, kind.garden);
    const int storeys =
        kind.low +
        static_cast<int>(random_.below(static_cast<std::uint64_t>(kind.high - kind.low + 1)));
    double s = stretch_.begin + draw(0, 4);
    while (s < stretch_.end) {
      const double half_length = draw(kind.narrow, kind.wide) / 2;
      const double half_depth = kind.depth / 2 * draw(0.85, 1.15);
      const double middle = s + half_length;
      s = middle + half_length + draw(0.05, kind.gap);
      House house;
      house.seed = drawSeed();
      house.roof = chance(kind.flat)
                       ? RoofShape::Flat
                       : (chance(0.65) ? RoofShape::AlongStreet : RoofShape::ToStreet);
      house.storeys = std::max(1, storeys + static_cast<int>(random_.below(2)) - 1);
      if (middle > stretch_.end || !chance(stretch_.density)) continue;
      house.plot = plotAt(middle, kFence + garden + half_depth, half_length, half_depth);
      house.ground = groundAt(house.plot);
      if (!book_.enter(house.plot, kFence)) continue;
      addHouse(world_, house);
      frontGarden(middle, half_length, garden);
    }
  }

  /// A second row of houses, visible between those of the first.
  void backHouses() {
    double s = stretch_.begin + draw(0, 12);
    while (s < stretch_.end) {
      House house;
      house.seed = drawSeed();
      house.storeys = 2 + static_cast<int>(random_.below(3));
      house.roof = chance(0.3) ? RoofShape::Flat : RoofShape::ToStreet;
      const double half_length = draw(4.5, 9);
      const double half_depth = draw(4, 6);
      house.plot = plotAt(s + half_length, draw(30, 42), half_length, half_depth);
      house.ground = groundAt(house.plot);
      s += 2 * half_length + draw(3, 14);
      if (chance(stretch_.density) && book_.enter(house.plot, 2 * kFence)) addHouse(world_, house);
    }
  }

  void frontGarden(double s, double half_length, double garden) {
    const std::uint32_t seed = drawSeed();
    const double kind = random_.uniform();
    const bool bush = chance(0.6);
    const double where = draw(-0.8, 0.8);
    if (garden < 1.2) return;
    const bool is_fence = kind < 0.3;
    const double half_depth = is_fence ? 0.04 : 0.35;
    const Plot edge = plotAt(s, kFence + half_depth, half_length, half_depth);
    if (kind < 0.65 && book_.enter(edge, kFence - 0.1)) {
      (is_fence ? addFence : addHedge)(world_, edge, groundAt(edge), seed);
    }
    const Plot spot = plotAt(s + where * half_length, kFence + 0.7 * garden, 0.4, 0.3);
    if (!bush || !book_.enter(spot, kFence)) return;
    const double scale = draw(0.6, 1.2);
    instance(prototypes_.bushes, spot, draw(0, 6), scale);
  }

  void streetTrees() {
    const double spacing = draw(7, 14);
    const double over = kFence - draw(0.2, 0.5);
    for (double s = stretch_.begin + draw(1, 5); s < stretch_.end; s += spacing) {
      const Plot spot = plotAt(s, over, 0.25, 0.25);
      const double yaw = draw(0, 6.28);
      const double scale = draw(0.8, 1.15);
      if (chance(stretch_.density) && book_.enter(spot, over - 0.5)) {
        instance(prototypes_.street_trees, spot, yaw, scale);
      }
    }
  }

  /// Bushes and low growth behind the pavement.
  void verge() {
    for (double s = stretch_.begin + draw(0, 3); s < stretch_.end; s += draw(2, 9)) {
      const Plot spot = plotAt(s, kFence + draw(0.8, 3.5), 0.5, 0.5);
      const double yaw = draw(0, 6.28);
      const double scale = draw(0.35, 0.9);
      if (chance(0.7 * stretch_.density) && book_.enter(spot, kFence)) {
        instance(prototypes_.bushes, spot, yaw, scale);
      }
    }
  }

  void gardenTrees(double count, double nearest) {
    for (int i = 0; i < static_cast<int>(count * stretch_.density); ++i) {
      // Denser near the street.
      const double over = nearest + (58 - nearest) * std::pow(random_.uniform(), 1.7);
      const Plot spot = plotAt(draw(stretch_.begin, stretch_.end), over, 0.8, 0.8);
      const double yaw = draw(0, 6.28);
      const double scale = draw(0.7, 1.25);
      const bool small = chance(0.35);
      if (book_.enter(spot, kFence + 1.5)) {
        instance(small ? prototypes_.bushes : prototypes_.garden_trees, spot, yaw, scale);
      }
    }
  }

  void parkedCars() {
    const double share = draw(0.1, 0.9);
    constexpr double kOver = StreetPlan::kRoadHalfWidth + 0.95;  // two wheels on the pavement
    for (double s = stretch_.begin + draw(2, 6); s < stretch_.end; s += draw(5.6, 8)) {
      const Plot spot = plotAt(s, kOver, 2.5, 0.9);
      const bool turned = chance(0.2);
      if (!chance(share * stretch_.density) || !book_.enter(spot, kOver - 1)) continue;
      instance(prototypes_.cars, spot, turned ? 3.1416 : 0.0, 1);
    }
  }

  void lampsAndSigns() {
    constexpr double kOver = StreetPlan::kRoadHalfWidth + 0.45;
    const double s = stretch_.begin + draw(2, 12);
    const Stand lamp = standAt(s, kOver);
    if (book_.enter(plotAt(s, kOver, 0.15, 0.15), kOver - 0.2)) addLamp(world_, lamp);
    const double at = stretch_.begin + draw(15, 40);
    const Stand sign = standAt(at, kOver);
    const bool wanted = chance(0.5);
    if (wanted && at < stretch_.end && book_.enter(plotAt(at, kOver, 0.4, 0.4), kOver - 0.5)) {
      addSign(world_, sign);
    }
    const double poster_at = stretch_.begin + draw(10, 40);
    const double over = kFence + 2.5;
    const Stand poster = standAt(poster_at, over);
    if (chance(0.2) && poster_at < stretch_.end &&
        book_.enter(plotAt(poster_at, over, 0.3, 1.6), kFence)) {
      addPoster(world_, poster);
    }
  }

  World& world_;
  const StreetPlan& plan_;
  const Prototypes& prototypes_;
  PlotBook& book_;
  const Stretch& stretch_;
  RandomStream random_;
};

/// Seed of a stretch. Most stretches have their own; a share of `aliasing` has one of two common
/// ones and so looks like others.
std::uint32_t stretchSeed(const WorldOptions& options, std::uint32_t section, std::uint32_t number,
                          bool left) {
  const std::uint32_t own = hash(options.seed, section, 2 * number + (left ? 1U : 0U));
  if (unit(hash(own, 71)) >= static_cast<float>(options.aliasing)) return own;
  return hash(options.seed, 5000 + hash(own, 72) % 2);
}

void layOut(World& world, const StreetPlan& plan, const Prototypes& prototypes,
            const WorldOptions& options) {
  PlotBook book(plan);
  for (const Plot& plot : options.reserved) book.enter(plot, 0);
  for (std::uint32_t i = 0; i < plan.sections().size(); ++i) {
    const StreetSection& section = plan.sections()[i];
    if (section.points.empty()) continue;
    const double length = section.points.back().s;
    for (std::uint32_t number = 0; number * kStretch < length; ++number) {
      for (const bool left : {false, true}) {
        const double begin = number * kStretch;
        const Stretch stretch = {&section,
                                 left,
                                 begin,
                                 std::min(begin + kStretch, length),
                                 stretchSeed(options, i, number, left),
                                 options.density};
        StretchBuilder(world, plan, prototypes, book, stretch).fill();
      }
    }
  }
}

}  // namespace

bool overlap(const Plot& a, const Plot& b) { return !separatedBy(a, b) && !separatedBy(b, a); }

bool PlotBook::clearOfStreets(const Plot& plot, double clearance) const {
  // Samples 1.5 m apart cover the plot; a street is wider than their distance.
  const int columns = 1 + static_cast<int>(std::ceil(plot.half_length / 0.75));
  const int rows = 1 + static_cast<int>(std::ceil(plot.half_depth / 0.75));
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double along = plot.half_length * (2.0 * i / (columns - 1) - 1);
      const double over = plot.half_depth * (2.0 * j / (rows - 1) - 1);
      const Eigen::Vector2d p = plot.point(along, over);
      if (plan_->distance(p.x(), p.y()) < clearance) return false;
    }
  }
  return true;
}

bool PlotBook::enter(const Plot& plot, double clearance) {
  if (!clearOfStreets(plot, clearance)) return false;
  for (const std::size_t other : grid_.near(plot.centre)) {
    if (overlap(plot, plots_[other])) return false;
  }
  grid_.add(plot.centre, plots_.size());
  plots_.push_back(plot);
  return true;
}

World buildWorld(const StreetPlan& plan, const WorldOptions& options) {
  constexpr double kBesideTown = 40;  // m, for shadows of what stands at its border
  World world;
  const auto add = [&](Material material, float tone) {
    const auto number = static_cast<std::uint32_t>(material);
    return world.addSurface(
        {.material = material, .seed = hash(options.seed, number, 13), .tone = tone});
  };
  const GroundSurfaces ground = {add(Material::Road, 0.2F), add(Material::Kerb, 0.33F),
                                 add(Material::Land, 0.2F)};
  world.fixed = buildGround(plan, ground);
  world.ground_triangles = world.fixed.triangles.size();
  world.area = {toVec3(plan.lowCorner().array() - kBesideTown, 0),
                toVec3(plan.highCorner().array() + kBesideTown, 0)};
  addLaneMarkings(world, plan, hash(options.seed, 61));
  if (options.guard_rails) addGuardRails(world, plan);
  addHorizon(world, plan, hash(options.seed, 62));
  const Prototypes prototypes = addPrototypes(world, options.seed);
  layOut(world, plan, prototypes, options);
  world.cars = prototypes.cars;
  return world;
}

}  // namespace tolman::town
