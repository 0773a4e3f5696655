// SPDX-License-Identifier: BSD-3-Clause
// Trees, bushes and cars, each built once and placed many times; trees without leaves and other
// parked cars.
#include <algorithm>
#include <map>
#include <numbers>

#include "noise.hpp"
#include "objects.hpp"
#include "tolman/context.hpp"
#include "world.hpp"

namespace tolman::town {
namespace {

constexpr std::size_t kLeavesPerTwig = 30;

/// A trunk, and a crown of rough lumps with holes between them.
class PlantBuilder {
 public:
  PlantBuilder(World& world, std::uint32_t seed)
      : world_(world),
        seed_(seed),
        random_(seed),
        leaves_(world.addSurface({.material = Material::Leaves,
                                  .seed = seed,
                                  .tone = between(hash(seed, 1), 0.1F, 0.2F)})),
        bark_(world.addSurface({.material = Material::Bark,
                                .seed = seed,
                                .tone = between(hash(seed, 2), 0.08F, 0.2F)})) {}

  std::uint32_t broadleaf(float height, float clear_trunk) {
    const float girth = 0.018F * height;
    addPost(mesh_, {{0, 0, -0.5F}, {0, 0, 0.75F * height}, girth, 0.3F * girth, 9}, bark_);
    const float crown = height - clear_trunk;
    const float width = 0.36F * crown;
    for (std::uint32_t i = 0; i < 16; ++i) {
      const float level = draw(0.08F, 0.92F);
      const float girdle = std::sin(std::numbers::pi_v<float> * std::pow(level, 0.8F));
      Vec3 centre = onCircle(width * girdle * draw(0.25F, 1.0F));
      centre.z = clear_trunk + crown * level;
      const float r = width * draw(0.32F, 0.55F);
      addLump(mesh_, {centre, {r, r, 0.75F * r}, 0.25F, 2, seed_ + i}, leaves_);
      if (i % 4 == 0) {
        const Vec3 fork = {0, 0, centre.z - 0.35F * crown * level};
        addPost(mesh_, {fork, centre, 0.4F * girth, 0.12F * girth, 6}, bark_);
      }
      for (int twig = 0; twig < 10; ++twig) {
        const Vec3 way = normalised(Vec3{draw(-1, 1), draw(-1, 1), draw(-0.8F, 1)});
        addTwig(centre + way * (1.05F * r), 0.16F);
      }
    }
    return world_.addPrototype(std::move(mesh_));
  }

  std::uint32_t conifer(float height) {
    addPost(mesh_, {{0, 0, -0.5F}, {0, 0, height}, 0.02F * height, 0.02F, 8}, bark_);
    constexpr std::uint32_t kWhorls = 9;
    for (std::uint32_t i = 0; i < kWhorls; ++i) {
      const float level = 0.1F + 0.88F * static_cast<float>(i) / kWhorls;
      const float reach = 0.24F * height * (1.02F - level);
      for (std::uint32_t branch = 0; branch < 5; ++branch) {
        Vec3 centre = onCircle(0.55F * reach);
        centre.z = level * height;
        const Vec3 radii = {0.62F * reach, 0.62F * reach, 0.07F * height};
        addLump(mesh_, {centre, radii, 0.3F, 2, seed_ + i * 8 + branch}, leaves_);
      }
    }
    return world_.addPrototype(std::move(mesh_));
  }

  std::uint32_t bush(float size) {
    for (std::uint32_t i = 0; i < 6; ++i) {
      Vec3 centre = onCircle(draw(0, 0.45F) * size);
      centre.z = draw(0.15F, 0.5F) * size;
      const float r = size * draw(0.25F, 0.45F);
      addLump(mesh_, {centre, {r, r, r}, 0.25F, 2, seed_ + i}, leaves_);
    }
    return world_.addPrototype(std::move(mesh_));
  }

 private:
  float draw(float low, float high) { return static_cast<float>(random_.uniform(low, high)); }

  Vec3 onCircle(float radius) {
    const float angle = draw(0, 2 * std::numbers::pi_v<float>);
    return {radius * std::cos(angle), radius * std::sin(angle), 0};
  }

  /// Two crossed triangles of leaves that roughen the outline of the crown.
  void addTwig(const Vec3& at, float size) {
    for (int i = 0; i < 2; ++i) {
      std::array<Vec3, 3> corners;
      for (Vec3& corner : corners) {
        corner = at + Vec3{draw(-size, size), draw(-size, size), draw(-size, size)};
      }
      addTriangle(mesh_, corners, leaves_);
    }
  }

  World& world_;
  std::uint32_t seed_;
  RandomStream random_;
  std::uint32_t leaves_;
  std::uint32_t bark_;
  Mesh mesh_;
};

/// Side view of a car: what differs between the kinds.
struct CarShape {
  float length = 4.2F;
  float height = 1.45F;
  float bonnet = 1.05F;  ///< m from the front to the windscreen's foot
  float screen = 0.75F;  ///< m that the windscreen leans back
  float tail = 0.3F;     ///< m that the rear window leans
  float boot = 0.0F;     ///< m of boot behind the rear window
};

constexpr float kHalfWidth = 0.86F;  // m
constexpr float kWaist = 0.9F;       // m, Z of the lower edge of the windows

struct OutlinePoint {
  float x;
  float z;
};

/// From the front bumper over the roof to the rear bumper.
std::array<OutlinePoint, 11> outline(const CarShape& s) {
  const float front = s.length / 2;
  const float rear = -s.length / 2;
  const float screen_foot = front - s.bonnet;
  const float window_foot = rear + s.boot;
  return {{{front, 0.25F},
           {front, 0.55F},
           {front - 0.15F, 0.72F},
           {screen_foot, kWaist},
           {screen_foot - s.screen, s.height - 0.04F},
           {0.5F * (screen_foot - s.screen + window_foot + s.tail), s.height},
           {window_foot + s.tail, s.height - 0.05F},
           {window_foot, kWaist + 0.02F},
           {rear, kWaist - 0.03F},
           {rear, 0.5F},
           {rear + 0.05F, 0.25F}}};
}

void addWheel(Mesh& mesh, float x, float y, std::uint32_t surface) {
  constexpr float kWheelRadius = 0.31F;
  const float side = y > 0 ? 1.0F : -1.0F;
  const Vec3 outer = {x, y + 0.02F * side, kWheelRadius};
  const Vec3 inner = {x, y - 0.18F * side, kWheelRadius};
  addPost(mesh, {inner, outer, kWheelRadius, kWheelRadius, 14}, surface);
  addPost(mesh, {outer, outer + Vec3{0, 0.001F * side, 0}, kWheelRadius, 0.01F, 14}, surface);
}

/// The outline, extruded to both sides and narrower towards the roof.
std::uint32_t addCar(World& world, const CarShape& shape) {
  const std::uint32_t paint = world.addSurface({.material = Material::Body, .tone = 0.42F});
  const std::uint32_t tyre = world.addSurface({.tone = 0.04F});
  Mesh mesh;
  const auto points = outline(shape);
  const auto at = [&](const OutlinePoint& p, float side) {
    const float half = p.z <= kWaist ? kHalfWidth : kHalfWidth - 0.28F * (p.z - kWaist);
    return Vec3{p.x, side * half, p.z};
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
  return world.addPrototype(std::move(mesh));
}

bool isLeaf(const World& world, std::uint32_t surface) {
  return world.surfaces[surface].material == Material::Leaves;
}

bool contains(const std::vector<std::uint32_t>& list, std::uint32_t value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

/// The mesh with its trunk, and a twig from it to some of the leaves.
Mesh withoutLeaves(const World& world, const Mesh& leafy, std::uint32_t bark) {
  Mesh bare;
  std::size_t leaves = 0;
  for (std::size_t i = 0; i < leafy.triangles.size(); ++i) {
    const std::array<Vec3, 3> corners = leafy.corners(i);
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
  return world.addSurface({.material = Material::Bark, .tone = 0.14F});
}

}  // namespace

Prototypes addPrototypes(World& world, std::uint32_t seed) {
  Prototypes prototypes;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t own = hash(seed, i, 41);
    prototypes.street_trees.push_back(
        PlantBuilder(world, own)
            .broadleaf(between(hash(own, 1), 5.5F, 9), between(hash(own, 2), 1.9F, 2.6F)));
    prototypes.garden_trees.push_back(
        PlantBuilder(world, own + 1)
            .broadleaf(between(hash(own, 3), 7, 14), between(hash(own, 4), 0.9F, 2)));
    prototypes.bushes.push_back(
        PlantBuilder(world, own + 2).bush(between(hash(own, 5), 0.9F, 2.2F)));
  }
  for (std::uint32_t i = 0; i < 2; ++i) {
    const std::uint32_t own = hash(seed, i, 43);
    world.evergreens.push_back(PlantBuilder(world, own).conifer(between(own, 7, 13)));
    prototypes.garden_trees.push_back(world.evergreens.back());
  }
  for (const CarShape& shape :
       {CarShape{}, CarShape{4.6F, 1.43F, 1.2F, 0.8F, 0.75F, 0.6F},
        CarShape{4.7F, 1.5F, 1.15F, 0.75F, 0.2F, 0}, CarShape{5.0F, 2.0F, 0.8F, 0.6F, 0.1F, 0}}) {
    prototypes.cars.push_back(addCar(world, shape));
  }
  return prototypes;
}

Exchange addBareTrees(World& world) {
  std::map<std::uint32_t, std::uint32_t> bare_of;
  const auto prototypes = static_cast<std::uint32_t>(world.prototypes.size());
  for (std::uint32_t i = 0; i < prototypes; ++i) {
    const std::vector<std::uint32_t>& surfaces = world.prototypes[i].surfaces;
    const bool has_leaves = std::any_of(surfaces.begin(), surfaces.end(),
                                        [&](std::uint32_t s) { return isLeaf(world, s); });
    if (!has_leaves || contains(world.evergreens, i)) continue;
    const std::uint32_t bark = barkOf(world, world.prototypes[i]);
    bare_of[i] = world.addPrototype(withoutLeaves(world, world.prototypes[i], bark));
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
