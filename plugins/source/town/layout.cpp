// SPDX-License-Identifier: BSD-3-Clause
#include "layout.hpp"

#include <algorithm>

#include "furniture.hpp"
#include "ground.hpp"
#include "noise.hpp"
#include "stretch.hpp"

namespace tolman::town {
namespace {

constexpr double kStretch = 45;  // m, length of one kind of place

/// Seed of a stretch. Most stretches have their own; a share of `aliasing` has one of two common
/// ones and so looks like others.
std::uint32_t stretchSeed(const WorldOptions& options, std::uint32_t section, std::uint32_t number,
                          bool left) {
  const std::uint32_t own = hash(options.seed, section, 2 * number + (left ? 1U : 0U));
  if (unit(hash(own, 71)) >= static_cast<float>(options.aliasing)) return own;
  return hash(options.seed, 5000 + hash(own, 72) % 2);
}

/// With the shadows of what stands at its border.
GroundArea areaOf(const StreetPlan& plan) {
  constexpr double kBesideTown = 40;  // m
  const Eigen::Vector2f low = (plan.lowCorner().array() - kBesideTown).cast<float>();
  const Eigen::Vector2f high = (plan.highCorner().array() + kBesideTown).cast<float>();
  return {{low.x(), low.y(), 0}, {high.x(), high.y(), 0}};
}

}  // namespace

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
        StretchBuilder builder(world, plan, prototypes, book);
        builder.fill({&section, left, begin, std::min(begin + kStretch, length),
                      stretchSeed(options, i, number, left), options.density});
      }
    }
  }
}

World buildWorld(const StreetPlan& plan, const WorldOptions& options) {
  World world;
  const auto add = [&](Material material, float tone) {
    Surface surface;
    surface.material = material;
    surface.tone = tone;
    surface.seed = hash(options.seed, static_cast<std::uint32_t>(material), 13);
    return world.addSurface(surface);
  };
  const GroundSurfaces ground = {add(Material::Road, 0.2F), add(Material::Kerb, 0.33F),
                                 add(Material::Land, 0.2F)};
  world.fixed = buildGround(plan, ground);
  world.ground_triangles = world.fixed.triangles.size();
  world.area = areaOf(plan);
  addLaneMarkings(world, plan, hash(options.seed, 61));
  if (options.guard_rails) addGuardRails(world, plan);
  addHorizon(world, plan, hash(options.seed, 62));
  const Prototypes prototypes = addPrototypes(world, options.seed);
  layOut(world, plan, prototypes, options);
  world.cars = prototypes.cars;
  return world;
}

}  // namespace tolman::town
