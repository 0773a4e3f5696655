// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>

#include "noise.hpp"
#include "objects.hpp"
#include "shapes.hpp"

namespace tolman::town {
namespace {

constexpr std::size_t kLeavesPerTwig = 30;

bool isLeaf(const World& world, std::uint32_t surface) {
  return world.surfaces[surface].material == Material::Leaves;
}

Vec3 corner(const Mesh& mesh, std::uint32_t vertex) {
  const Mesh::Vertex& v = mesh.vertices[vertex];
  return {v.x, v.y, v.z};
}

/// The mesh with its trunk, and a twig from it to some of the leaves.
Mesh withoutLeaves(const World& world, const Mesh& leafy, std::uint32_t bark) {
  Mesh bare;
  std::size_t leaves = 0;
  for (std::size_t i = 0; i < leafy.triangles.size(); ++i) {
    const Mesh::Triangle& t = leafy.triangles[i];
    const std::array<Vec3, 3> corners = {corner(leafy, t[0]), corner(leafy, t[1]),
                                         corner(leafy, t[2])};
    if (!isLeaf(world, leafy.surfaces[i])) {
      addTriangle(bare, corners, leafy.surfaces[i]);
    } else if (leaves++ % kLeavesPerTwig == 0) {
      const Vec3 tip = corners[0];
      const Vec3 fork = {0.15F * tip.x, 0.15F * tip.y, 0.72F * tip.z};
      const float length = norm(tip - fork);
      addPost(bare, {fork, tip, 0.012F * length + 0.004F, 0.004F, 3}, bark);
    }
  }
  return bare;
}

/// The surface of the trunk of a mesh; for bushes, which have none, a new one.
std::uint32_t barkOf(World& world, const Mesh& mesh) {
  for (const std::uint32_t surface : mesh.surfaces) {
    if (!isLeaf(world, surface)) return surface;
  }
  Surface bark;
  bark.material = Material::Bark;
  bark.tone = 0.14F;
  return world.addSurface(bark);
}

bool contains(const std::vector<std::uint32_t>& list, std::uint32_t value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

}  // namespace

Exchange addBareTrees(World& world) {
  std::map<std::uint32_t, std::uint32_t> bare_of;
  const auto prototypes = static_cast<std::uint32_t>(world.prototypes.size());
  for (std::uint32_t i = 0; i < prototypes; ++i) {
    const Mesh& mesh = world.prototypes[i];
    const bool has_leaves = std::any_of(mesh.surfaces.begin(), mesh.surfaces.end(),
                                        [&](std::uint32_t s) { return isLeaf(world, s); });
    if (!has_leaves || contains(world.evergreens, i)) continue;
    const std::uint32_t bark = barkOf(world, mesh);
    bare_of[i] = static_cast<std::uint32_t>(world.prototypes.size());
    world.prototypes.push_back(withoutLeaves(world, world.prototypes[i], bark));
  }
  Exchange exchange;
  const std::size_t instances = world.instances.size();
  for (std::size_t i = 0; i < instances; ++i) {
    const auto bare = bare_of.find(world.instances[i].prototype);
    if (bare == bare_of.end()) continue;
    MeshInstance instance = world.instances[i];
    instance.prototype = bare->second;
    exchange.usual.push_back(i);
    exchange.other.push_back(world.instances.size());
    world.instances.push_back(instance);
  }
  return exchange;
}

Exchange addOtherCars(World& world, std::uint32_t seed) {
  Exchange exchange;
  const std::size_t instances = world.instances.size();
  for (std::size_t i = 0; i < instances; ++i) {
    MeshInstance car = world.instances[i];
    if (!contains(world.cars, car.prototype)) continue;
    exchange.usual.push_back(i);
    const std::uint32_t own = hash(seed, car.seed, 701);
    if (unit(hash(own, 1)) > 0.67F) continue;
    car.prototype = world.cars[hash(own, 2) % world.cars.size()];
    car.seed = own;
    const Vec3 along = car.placement.rotate({between(hash(own, 3), -0.4F, 0.4F), 0, 0});
    car.placement.position = car.placement.position + along;
    exchange.other.push_back(world.instances.size());
    world.instances.push_back(car);
  }
  return exchange;
}

}  // namespace tolman::town
