// SPDX-License-Identifier: BSD-3-Clause
// Cars and plants: of the requested size, cars on the ground, plants rooted in it.
#include "prototypes.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman::town;

namespace {

struct MaterialExtent {
  Vec3 low = {1e9F, 1e9F, 1e9F};
  Vec3 high = {-1e9F, -1e9F, -1e9F};

  void take(const Mesh::Vertex& v) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
};

/// Of the triangles of one material.
MaterialExtent extentOf(const World& world, const Mesh& mesh, Material material) {
  MaterialExtent extent;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (world.surfaces[mesh.surfaces[i]].material != material) continue;
    for (const std::uint32_t corner : mesh.triangles[i]) extent.take(mesh.vertices[corner]);
  }
  return extent;
}

}  // namespace

TEST_CASE("a car is as long and high as its shape, stands on its wheels and is symmetric") {
  World world;
  for (const CarShape& shape :
       {CarShape{}, CarShape{4.6F, 1.43F, 1.2F, 0.8F, 0.75F, 0.6F}, CarShape{5, 2, 0.8F}}) {
    const Mesh& car = world.prototypes[addCar(world, shape)];
    const MaterialExtent body = extentOf(world, car, Material::Body);
    CHECK(body.high.x - body.low.x == Approx(shape.length));
    CHECK(body.high.x == Approx(-body.low.x));
    CHECK(body.high.z == Approx(shape.height));
    CHECK(body.low.z > 0.1F);  // ground clearance
    CHECK(body.high.y - body.low.y > 1.6F);
    CHECK(body.high.y - body.low.y < 1.9F);
    const MaterialExtent wheels = extentOf(world, car, Material::Plain);
    CHECK(wheels.low.z == Approx(0).margin(0.02));
    CHECK(wheels.high.z < 0.7F);
    CHECK(wheels.high.x < body.high.x);
    for (const Mesh::Vertex& v : car.vertices) {
      const bool mirrored =
          std::any_of(car.vertices.begin(), car.vertices.end(), [&](const Mesh::Vertex& other) {
            return std::abs(other.x - v.x) + std::abs(other.y + v.y) + std::abs(other.z - v.z) <
                   1e-3F;
          });
      REQUIRE(mirrored);
    }
  }
}

TEST_CASE("seen from the side the body of a car has no hole between sill and waist") {
  World world;
  const Mesh& car = world.prototypes[addCar(world, {})];
  // A line of sight along Y through (x, z) crosses the two sides, once each.
  const auto crossings = [&](float x, float z) {
    int count = 0;
    for (std::size_t i = 0; i < car.triangles.size(); ++i) {
      if (world.surfaces[car.surfaces[i]].material != Material::Body) continue;
      std::array<Mesh::Vertex, 3> v{};
      for (std::size_t k = 0; k < 3; ++k) v[k] = car.vertices[car.triangles[i][k]];
      int positive = 0;
      int negative = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Mesh::Vertex& a = v[k];
        const Mesh::Vertex& b = v[(k + 1) % 3];
        const float side = (b.x - a.x) * (z - a.z) - (b.z - a.z) * (x - a.x);
        positive += side > 1e-6F;
        negative += side < -1e-6F;
      }
      count += positive == 3 || negative == 3;
    }
    return count;
  };
  for (float x = -1.913F; x < 1.9F; x += 0.171F) {
    for (float z = 0.311F; z < 0.7F; z += 0.093F) {
      CAPTURE(x, z);
      REQUIRE(crossings(x, z) == 2);
    }
  }
  CHECK(crossings(0, 1.6F) == 0);
}

TEST_CASE("a broad-leaved tree is about as high as asked, with a free trunk rooted in the ground") {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    World world;
    const float height = 5 + 0.8F * static_cast<float>(seed);
    const Mesh& tree = world.prototypes[addBroadleaf(world, height, 2, seed)];
    const MaterialExtent crown = extentOf(world, tree, Material::Leaves);
    const MaterialExtent trunk = extentOf(world, tree, Material::Bark);
    CAPTURE(seed, height, crown.high.z, crown.low.z);
    CHECK(crown.high.z > 0.75F * height);
    CHECK(crown.high.z < 1.25F * height);
    CHECK(crown.low.z > 0.2F);
    CHECK(trunk.low.z < 0);
    CHECK(trunk.high.z < crown.high.z);
  }
}

TEST_CASE("a conifer is a cone: broad below, narrow at the top") {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    World world;
    const Mesh& tree = world.prototypes[addConifer(world, 10, seed)];
    std::array<float, 3> reach{};  // of the lower, middle and upper third
    for (std::size_t i = 0; i < tree.triangles.size(); ++i) {
      if (world.surfaces[tree.surfaces[i]].material != Material::Leaves) continue;
      for (const std::uint32_t corner : tree.triangles[i]) {
        const Mesh::Vertex& v = tree.vertices[corner];
        const auto third = static_cast<std::size_t>(std::clamp(v.z / 10 * 3, 0.0F, 2.0F));
        reach[third] = std::max(reach[third], std::hypot(v.x, v.y));
      }
    }
    CAPTURE(seed, reach[0], reach[1], reach[2]);
    CHECK(reach[0] > reach[1]);
    CHECK(reach[1] > reach[2]);
    CHECK(reach[2] > 0);
  }
}

TEST_CASE("bushes grow with their size, and a seed makes one plant") {
  const auto bush = [](float size, std::uint32_t seed) {
    World world;
    const Mesh mesh = world.prototypes[addBush(world, size, seed)];
    return extentOf(world, mesh, Material::Leaves);
  };
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    const MaterialExtent small = bush(1, seed);
    const MaterialExtent large = bush(2, seed);
    CHECK(large.high.z == Approx(2 * small.high.z).epsilon(0.1));
    CHECK(small.high.z > 0.4F);
    CHECK(small.high.z < 1.3F);
    CHECK(bush(1, seed).high.x == small.high.x);
  }
  CHECK(bush(1, 1).high.x != bush(1, 2).high.x);
}

TEST_CASE("all prototypes are there, each index a mesh of its own") {
  World world;
  const Prototypes all = addPrototypes(world, 3);
  std::vector<std::uint32_t> indices;
  for (const auto* group : {&all.street_trees, &all.garden_trees, &all.bushes, &all.cars}) {
    CHECK(group->size() >= 4);
    indices.insert(indices.end(), group->begin(), group->end());
  }
  std::sort(indices.begin(), indices.end());
  REQUIRE(indices.size() == world.prototypes.size());
  for (std::size_t i = 0; i < indices.size(); ++i) CHECK(indices[i] == i);
}
