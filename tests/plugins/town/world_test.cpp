// SPDX-License-Identifier: BSD-3-Clause
// Objects of the town: equal for equal seeds, more with a higher density, none on the road.
#include "world.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "small_town.hpp"

using namespace tolman;
using namespace tolman::town;
using town::test::SmallTown;

namespace {

World worldOf(const SmallTown& town, WorldOptions options) {
  return buildWorld(town.plan, options);
}

bool sameMesh(const Mesh& a, const Mesh& b) {
  return a.triangles == b.triangles && a.surfaces == b.surfaces &&
         std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                    [](const Mesh::Vertex& p, const Mesh::Vertex& q) {
                      return p.x == q.x && p.y == q.y && p.z == q.z;
                    });
}

}  // namespace

TEST_CASE("a seed makes one town, another seed another") {
  const SmallTown town;
  const World a = worldOf(town, {3, 0.15, 1, false, {}});
  const World b = worldOf(town, {3, 0.15, 1, false, {}});
  const World c = worldOf(town, {4, 0.15, 1, false, {}});
  CHECK(sameMesh(a.fixed, b.fixed));
  CHECK(a.instances.size() == b.instances.size());
  CHECK_FALSE(sameMesh(a.fixed, c.fixed));
}

TEST_CASE("density thins out, and 0 leaves bare streets") {
  const SmallTown town;
  const World full = worldOf(town, {3, 0.15, 1, false, {}});
  const World half = worldOf(town, {3, 0.15, 0.5, false, {}});
  const World bare = worldOf(town, {3, 0.15, 0, false, {}});
  CHECK(full.instances.size() > half.instances.size());
  CHECK(bare.instances.empty());
  CHECK(full.instances.size() > 60);
}

TEST_CASE("nothing but kerb, land and paint is on the road") {
  const SmallTown town(makeLight(12, Weather::Clear, 0, 1), {}, "district");
  const World world = worldOf(town, {});
  for (const MeshInstance& instance : world.instances) {
    const Vec3& p = instance.placement.position;
    REQUIRE(town.plan.distance(p.x, p.y) > StreetPlan::kRoadHalfWidth);
  }
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < world.fixed.triangles.size(); ++i) {
    const Material material = world.surfaces[world.fixed.surfaces[i]].material;
    if (material != Material::Facade && material != Material::Wood) continue;
    ++triangles;
    for (const std::uint32_t corner : world.fixed.triangles[i]) {
      const Mesh::Vertex& v = world.fixed.vertices[corner];
      REQUIRE(town.plan.distance(v.x, v.y) > StreetPlan::kRoadHalfWidth + 1.5);
    }
  }
  CHECK(triangles > 100);
}

TEST_CASE("every triangle has a surface, and every instance a prototype") {
  const SmallTown town;
  const World world = worldOf(town, {});
  REQUIRE(world.fixed.surfaces.size() == world.fixed.triangles.size());
  for (const std::uint32_t surface : world.fixed.surfaces) REQUIRE(surface < world.surfaces.size());
  for (const Mesh& prototype : world.prototypes) {
    REQUIRE_FALSE(prototype.triangles.empty());
    for (const std::uint32_t surface : prototype.surfaces) REQUIRE(surface < world.surfaces.size());
  }
  for (const MeshInstance& instance : world.instances) {
    REQUIRE(instance.prototype < world.prototypes.size());
  }
  CHECK_FALSE(world.cars.empty());
}

TEST_CASE("with aliasing 1 all street fronts are of two kinds, with 0 each is its own") {
  const SmallTown town(makeLight(12, Weather::Clear, 0, 1), {}, "district");
  const auto kindsOfHouses = [&](double aliasing) {
    const World world = worldOf(town, {1, aliasing, 1, false, {}});
    std::vector<std::uint32_t> seeds;
    for (const Surface& surface : world.surfaces) {
      if (surface.material == Material::Facade) seeds.push_back(surface.seed);
    }
    const std::size_t walls = seeds.size();
    std::sort(seeds.begin(), seeds.end());
    seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
    return static_cast<double>(seeds.size()) / static_cast<double>(walls);
  };
  CHECK(kindsOfHouses(0) == Approx(0.25).margin(0.01));  // four walls to a house
  CHECK(kindsOfHouses(1) < 0.15);
}
