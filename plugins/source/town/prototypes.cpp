// SPDX-License-Identifier: BSD-3-Clause
// Trees, bushes and cars: a trunk with a crown of rough lumps; the outline of a side view, extruded
// to both sides and narrower towards the roof.

#include <numbers>
#include <vector>

#include "noise.hpp"
#include "objects.hpp"
#include "shapes.hpp"
#include "tolman/context.hpp"

namespace tolman::town {

namespace {

struct PlantSurfaces {
  std::uint32_t leaves;
  std::uint32_t bark;
};

PlantSurfaces addSurfaces(World& world, std::uint32_t seed) {
  Surface leaves;
  leaves.material = Material::Leaves;
  leaves.seed = seed;
  leaves.tone = between(hash(seed, 1), 0.1F, 0.2F);
  Surface bark;
  bark.material = Material::Bark;
  bark.seed = seed;
  bark.tone = between(hash(seed, 2), 0.08F, 0.2F);
  return {world.addSurface(leaves), world.addSurface(bark)};
}

std::uint32_t finish(World& world, Mesh mesh) {
  world.prototypes.push_back(std::move(mesh));
  return static_cast<std::uint32_t>(world.prototypes.size() - 1);
}

float uniform(RandomStream& random, float low, float high) {
  return static_cast<float>(random.uniform(low, high));
}

Vec3 onCircle(RandomStream& random, float radius) {
  const float angle = uniform(random, 0, 2 * std::numbers::pi_v<float>);
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

/// A twig: two crossed quads of leaves that roughen the outline of the crown.
void addTwig(Mesh& mesh, const Vec3& at, float size, RandomStream& random, std::uint32_t leaves) {
  for (int i = 0; i < 2; ++i) {
    std::array<Vec3, 3> corners;
    for (Vec3& corner : corners) {
      corner = at + Vec3{uniform(random, -size, size), uniform(random, -size, size),
                         uniform(random, -size, size)};
    }
    addTriangle(mesh, corners, leaves);
  }
}

}  // namespace

std::uint32_t addBroadleaf(World& world, float height, float clear_trunk, std::uint32_t seed) {
  const PlantSurfaces surfaces = addSurfaces(world, seed);
  RandomStream random(seed);
  Mesh mesh;
  const float girth = 0.018F * height;
  addPost(mesh, {{0, 0, -0.5F}, {0, 0, 0.75F * height}, girth, 0.3F * girth, 9}, surfaces.bark);
  const float crown = height - clear_trunk;
  const float width = 0.36F * crown;
  for (int i = 0; i < 16; ++i) {
    const float level = uniform(random, 0.08F, 0.92F);
    const float girdle = std::sin(std::numbers::pi_v<float> * std::pow(level, 0.8F));
    Lump lump;
    lump.centre = onCircle(random, width * girdle * uniform(random, 0.25F, 1.0F));
    lump.centre.z = clear_trunk + crown * level;
    const float r = width * uniform(random, 0.32F, 0.55F);
    lump.radii = {r, r, 0.75F * r};
    lump.roughness = 0.25F;
    lump.detail = 2;
    lump.seed = seed + static_cast<std::uint32_t>(i);
    addLump(mesh, lump, surfaces.leaves);
    if (i % 4 == 0) {
      const Vec3 fork = {0, 0, lump.centre.z - 0.35F * crown * level};
      addPost(mesh, {fork, lump.centre, 0.4F * girth, 0.12F * girth, 6}, surfaces.bark);
    }
    for (int twig = 0; twig < 10; ++twig) {
      const Vec3 way = normalised(
          Vec3{uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -0.8F, 1)});
      addTwig(mesh, lump.centre + way * (1.05F * r), 0.16F, random, surfaces.leaves);
    }
  }
  return finish(world, std::move(mesh));
}

std::uint32_t addConifer(World& world, float height, std::uint32_t seed) {
  const PlantSurfaces surfaces = addSurfaces(world, seed);
  RandomStream random(seed);
  Mesh mesh;
  addPost(mesh, {{0, 0, -0.5F}, {0, 0, height}, 0.02F * height, 0.02F, 8}, surfaces.bark);
  constexpr int kWhorls = 9;
  for (int i = 0; i < kWhorls; ++i) {
    const float level = 0.1F + 0.88F * static_cast<float>(i) / kWhorls;
    const float reach = 0.24F * height * (1.02F - level);
    for (int branch = 0; branch < 5; ++branch) {
      Lump lump;
      lump.centre = onCircle(random, 0.55F * reach);
      lump.centre.z = level * height;
      lump.radii = {0.62F * reach, 0.62F * reach, 0.07F * height};
      lump.roughness = 0.3F;
      lump.detail = 2;
      lump.seed = seed + static_cast<std::uint32_t>(i * 8 + branch);
      addLump(mesh, lump, surfaces.leaves);
    }
  }
  return finish(world, std::move(mesh));
}

std::uint32_t addBush(World& world, float size, std::uint32_t seed) {
  const PlantSurfaces surfaces = addSurfaces(world, seed);
  RandomStream random(seed);
  Mesh mesh;
  for (int i = 0; i < 6; ++i) {
    Lump lump;
    lump.centre = onCircle(random, uniform(random, 0, 0.45F) * size);
    lump.centre.z = uniform(random, 0.15F, 0.5F) * size;
    const float r = size * uniform(random, 0.25F, 0.45F);
    lump.radii = {r, r, r};
    lump.roughness = 0.25F;
    lump.detail = 2;
    lump.seed = seed + static_cast<std::uint32_t>(i);
    addLump(mesh, lump, surfaces.leaves);
  }
  return finish(world, std::move(mesh));
}

Prototypes addPrototypes(World& world, std::uint32_t seed) {
  Prototypes prototypes;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t own = hash(seed, i, 41);
    prototypes.street_trees.push_back(addBroadleaf(world, between(hash(own, 1), 5.5F, 9),
                                                   between(hash(own, 2), 1.9F, 2.6F), own));
    prototypes.garden_trees.push_back(
        addBroadleaf(world, between(hash(own, 3), 7, 14), between(hash(own, 4), 0.9F, 2), own + 1));
    prototypes.bushes.push_back(addBush(world, between(hash(own, 5), 0.9F, 2.2F), own + 2));
  }
  for (std::uint32_t i = 0; i < 2; ++i) {
    const std::uint32_t own = hash(seed, i, 43);
    world.evergreens.push_back(addConifer(world, between(own, 7, 13), own));
    prototypes.garden_trees.push_back(world.evergreens.back());
  }
  prototypes.cars.push_back(addCar(world, {}));
  prototypes.cars.push_back(addCar(world, {4.6F, 1.43F, 1.2F, 0.8F, 0.75F, 0.6F}));
  prototypes.cars.push_back(addCar(world, {4.7F, 1.5F, 1.15F, 0.75F, 0.2F, 0}));
  prototypes.cars.push_back(addCar(world, {5.0F, 2.0F, 0.8F, 0.6F, 0.1F, 0}));
  return prototypes;
}

namespace {

constexpr float kHalfWidth = 0.86F;  // m
constexpr float kWaist = 0.9F;       // m, Z of the lower edge of the windows

struct OutlinePoint {
  float x;
  float z;
};

/// From the front bumper over the roof to the rear bumper.
std::vector<OutlinePoint> outline(const CarShape& s) {
  const float front = s.length / 2;
  const float rear = -s.length / 2;
  const float screen_foot = front - s.bonnet;
  const float window_foot = rear + s.boot;
  return {{front, 0.25F},
          {front, 0.55F},
          {front - 0.15F, 0.72F},
          {screen_foot, kWaist},
          {screen_foot - s.screen, s.height - 0.04F},
          {0.5F * (screen_foot - s.screen + window_foot + s.tail), s.height},
          {window_foot + s.tail, s.height - 0.05F},
          {window_foot, kWaist + 0.02F},
          {rear, kWaist - 0.03F},
          {rear, 0.5F},
          {rear + 0.05F, 0.25F}};
}

float halfWidth(float z) { return z <= kWaist ? kHalfWidth : kHalfWidth - 0.28F * (z - kWaist); }

void addWheel(Mesh& mesh, float x, float y, std::uint32_t surface) {
  constexpr float kWheelRadius = 0.31F;
  const float side = y > 0 ? 1.0F : -1.0F;
  const Vec3 outer = {x, y + 0.02F * side, kWheelRadius};
  const Vec3 inner = {x, y - 0.18F * side, kWheelRadius};
  addPost(mesh, {inner, outer, kWheelRadius, kWheelRadius, 14}, surface);
  addPost(mesh, {outer, outer + Vec3{0, 0.001F * side, 0}, kWheelRadius, 0.01F, 14}, surface);
}

}  // namespace

std::uint32_t addCar(World& world, const CarShape& shape) {
  Surface body;
  body.material = Material::Body;
  body.tone = 0.42F;
  const std::uint32_t paint = world.addSurface(body);
  Surface rubber;
  rubber.tone = 0.04F;
  const std::uint32_t tyre = world.addSurface(rubber);
  Mesh mesh;
  const std::vector<OutlinePoint> points = outline(shape);
  const auto at = [&](const OutlinePoint& p, float side) {
    return Vec3{p.x, side * halfWidth(p.z), p.z};
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    addQuad(mesh,
            {at(points[i], -1), at(points[i], 1), at(points[i + 1], 1), at(points[i + 1], -1)},
            paint);
  }
  // The sides are fans from the middle of the sill: the outline is star-shaped about this point.
  for (const float side : {-1.0F, 1.0F}) {
    const Vec3 middle = at({0, 0.25F}, side);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      addTriangle(mesh, {middle, at(points[i], side), at(points[i + 1], side)}, paint);
    }
    for (const float x : {0.31F, -0.31F}) {
      addWheel(mesh, x * shape.length, side * kHalfWidth, tyre);
    }
  }
  world.prototypes.push_back(std::move(mesh));
  return static_cast<std::uint32_t>(world.prototypes.size() - 1);
}

}  // namespace tolman::town
