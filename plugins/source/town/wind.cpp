// SPDX-License-Identifier: BSD-3-Clause
#include "wind.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "noise.hpp"

namespace tolman::town {
namespace {

constexpr float kLean =
    2.5e-4F;                 ///< of a plant, m per m of height in a wind of 1 m/s; by its square
constexpr float kGust = 40;  ///< m, size of gusts

}  // namespace

Wind::Wind(const World& world, double speed, std::uint32_t seed) : speed_(speed), seed_(seed) {
  if (speed <= 0) return;
  std::vector<bool> has_leaves;
  for (const Mesh& mesh : world.prototypes) {
    has_leaves.push_back(std::any_of(
        mesh.surfaces.begin(), mesh.surfaces.end(),
        [&](std::uint32_t s) { return world.surfaces[s].material == Material::Leaves; }));
  }
  for (std::size_t i = 0; i < world.instances.size(); ++i) {
    const MeshInstance& instance = world.instances[i];
    if (has_leaves[instance.prototype]) plants_.push_back({i, instance.placement, instance.seed});
  }
}

Placement Wind::at(const Plant& plant, double seconds) const {
  const auto t = static_cast<float>(seconds);
  const Vec3& place = plant.placement.position;
  // Gusts move with the wind, along X.
  const float gust =
      noise2((place.x - static_cast<float>(speed_) * t) / kGust, place.y / kGust, seed_);
  const float phase = 2 * std::numbers::pi_v<float> * unit(hash(plant.seed, 11));
  const float hertz = between(hash(plant.seed, 12), 0.25F, 0.5F);
  const float swing = std::sin(2 * std::numbers::pi_v<float> * hertz * t + phase);
  const float lean = kLean * static_cast<float>(speed_ * speed_);
  Placement placement = plant.placement;
  placement.lean_x = lean * (0.5F + 0.4F * gust + 0.35F * swing);
  placement.lean_y = lean * 0.25F * std::sin(2 * std::numbers::pi_v<float> * 0.8F * hertz * t);
  return placement;
}

}  // namespace tolman::town
