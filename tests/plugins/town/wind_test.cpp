// SPDX-License-Identifier: BSD-3-Clause
// Trees in the wind: which ones move, how far, and that the texture moves with the crown.
#include "wind.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "small_town.hpp"

using namespace tolman;
using namespace tolman::town;

TEST_CASE("plants with leaves sway about a lean that grows with the square of the speed") {
  const town::test::SmallTown town;
  const World world = buildWorld(town.plan, {});
  const Wind calm(world, 4, 1);
  const Wind gale(world, 16, 1);
  REQUIRE(calm.plants().size() > 50);
  REQUIRE(calm.plants().size() == gale.plants().size());
  for (const Wind::Plant& plant : calm.plants()) {
    const std::uint32_t prototype = world.instances.at(plant.instance).prototype;
    CHECK(std::find(world.cars.begin(), world.cars.end(), prototype) == world.cars.end());
  }
  float least = 1;
  float most = -1;
  for (double t = 0; t < 20; t += 0.3) {
    const Placement a = calm.at(calm.plants()[3], t);
    least = std::min(least, a.lean_x);
    most = std::max(most, a.lean_x);
    CHECK(std::abs(a.lean_x) < 0.01F);  // 8 cm of a tree of 8 m
    CHECK(std::abs(gale.at(gale.plants()[3], t).lean_x) < 0.16F);
  }
  CHECK(most - least > 1e-3F);
  CHECK(Wind(world, 0, 1).plants().empty());
}

TEST_CASE("points of a leaning plant keep their own coordinates") {
  Placement placement = Placement::at({3, -2, 1}, 0.7F, 1.2F);
  placement.lean_x = 0.05F;
  placement.lean_y = -0.02F;
  const Vec3 own = {0.4F, -0.9F, 6};
  const Vec3 turned = placement.rotate(own) * placement.scale;
  const Vec3 town = placement.position + turned +
                    Vec3{placement.lean_x * turned.z, placement.lean_y * turned.z, 0};
  const Vec3 back = placement.toLocal(town);
  CHECK(norm(back - own) < 1e-5F);
}
