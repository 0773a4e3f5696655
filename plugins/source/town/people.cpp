// SPDX-License-Identifier: BSD-3-Clause
#include "people.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "pedestrians.hpp"
#include "shapes.hpp"

namespace tolman::town {
namespace {

constexpr float kTurn = 2 * std::numbers::pi_v<float>;
constexpr float kThigh = 0.44F;  // m
constexpr float kShin = 0.46F;   // m, with the shoe

struct PersonSurfaces {
  std::uint32_t coat;
  std::uint32_t trousers;
  std::uint32_t skin;
  std::uint32_t metal;
};

PersonSurfaces addPersonSurfaces(World& world) {
  const auto cloth = [&](std::uint32_t seed) {
    Surface surface;
    surface.material = Material::Cloth;
    surface.seed = seed;
    return world.addSurface(surface);
  };
  const auto plain = [&](float tone) {
    Surface surface;
    surface.tone = tone;
    return world.addSurface(surface);
  };
  return {cloth(811), cloth(812), plain(0.35F), plain(0.12F)};
}

/// A limb of a direction `angle` rad forwards from straight down.
Vec3 limb(float angle, float length) {
  return {length * std::sin(angle), 0, -length * std::cos(angle)};
}

void addJointed(Mesh& mesh, const std::array<Vec3, 3>& joints, float radius,
                std::uint32_t surface) {
  addPost(mesh, {joints[0], joints[1], radius, 0.8F * radius, 7}, surface);
  addPost(mesh, {joints[1], joints[2], 0.8F * radius, 0.6F * radius, 7}, surface);
}

void addBall(Mesh& mesh, const Vec3& centre, const Vec3& radii, std::uint32_t surface) {
  addLump(mesh, {centre, radii, 0, 1, 0}, surface);
}

/// Joint between two limbs of given lengths whose ends are known; it bends forwards (+X).
Vec3 knee(const Vec3& hip, const Vec3& foot, float upper, float lower) {
  const Vec3 way = foot - hip;
  const float distance = std::min(norm(way), 0.999F * (upper + lower));
  const Vec3 along = normalised(way);
  const float a = (upper * upper - lower * lower + distance * distance) / (2 * distance);
  const float over = std::sqrt(std::max(0.0F, upper * upper - a * a));
  const Vec3 forward = normalised(Vec3{1, 0, 0} - along * along.x);
  return hip + along * a + forward * over;
}

/// `step` in [0, 1): phase of the stride; negative: standing.
Mesh walker(const PersonSurfaces& surfaces, float step) {
  Mesh mesh;
  constexpr float kHip = 0.88F;
  constexpr float kShoulder = 1.42F;
  const bool walks = step >= 0;
  for (const float side : {-1.0F, 1.0F}) {
    const float phase = step + (side > 0 ? 0.5F : 0.0F);
    const float swing = walks ? 0.42F * std::sin(kTurn * phase) : 0.03F * side;
    const float bend = walks ? 0.55F * std::max(0.0F, std::cos(kTurn * phase)) : 0;
    const Vec3 hip = {0, 0.09F * side, kHip};
    const Vec3 joint = hip + limb(swing + 0.3F * bend, kThigh);
    const Vec3 foot = joint + limb(swing - bend, kShin - 0.06F);
    addJointed(mesh, {hip, joint, foot}, 0.085F, surfaces.trousers);
    addBall(mesh, foot + Vec3{0.06F, 0, 0}, {0.13F, 0.05F, 0.05F}, surfaces.metal);
    const Vec3 shoulder = {0, 0.21F * side, kShoulder};
    const Vec3 elbow = shoulder + limb(-0.8F * swing, 0.3F);
    const Vec3 hand = elbow + limb(-0.8F * swing + 0.25F, 0.28F);
    addJointed(mesh, {shoulder, elbow, hand}, 0.055F, surfaces.coat);
    addBall(mesh, hand, {0.05F, 0.04F, 0.06F}, surfaces.skin);
  }
  addBall(mesh, {0, 0, 1.16F}, {0.14F, 0.2F, 0.36F}, surfaces.coat);
  addBall(mesh, {0.01F, 0, 1.62F}, {0.1F, 0.08F, 0.13F}, surfaces.skin);
  addBall(mesh, {-0.02F, 0, 1.68F}, {0.1F, 0.085F, 0.1F}, surfaces.metal);
  return mesh;
}

void addWheelRing(Mesh& mesh, float x, float radius, std::uint32_t surface) {
  constexpr int kSides = 16;
  const auto rim = [&](int i) {
    const float angle = kTurn * static_cast<float>(i) / kSides;
    return Vec3{x + radius * std::cos(angle), 0, radius + radius * std::sin(angle)};
  };
  for (int i = 0; i < kSides; ++i) {
    addPost(mesh, {rim(i), rim(i + 1), 0.018F, 0.018F, 5}, surface);
    if (i % 4 == 0) addPost(mesh, {rim(i), {x, 0, radius}, 0.004F, 0.004F, 3}, surface);
  }
}

void addBicycle(Mesh& mesh, std::uint32_t metal) {
  constexpr float kWheel = 0.34F;
  for (const float x : {-0.52F, 0.52F}) addWheelRing(mesh, x, kWheel, metal);
  const Vec3 crank = {-0.06F, 0, 0.3F};
  const Vec3 saddle = {-0.2F, 0, 0.92F};
  const Vec3 head = {0.36F, 0, 0.85F};
  const auto tube = [&](const Vec3& from, const Vec3& to) {
    addPost(mesh, {from, to, 0.02F, 0.02F, 6}, metal);
  };
  tube(crank, saddle);
  tube(crank, head);
  tube({-0.17F, 0, 0.8F}, head);
  tube(crank, {-0.52F, 0, kWheel});
  tube(saddle, {-0.52F, 0, kWheel});
  tube({0.34F, 0, 1.02F}, {0.52F, 0, kWheel});
  tube({0.36F, -0.26F, 1.04F}, {0.36F, 0.26F, 1.04F});
}

Mesh cyclist(const PersonSurfaces& surfaces, float turn) {
  Mesh mesh;
  addBicycle(mesh, surfaces.metal);
  for (const float side : {-1.0F, 1.0F}) {
    const float angle = kTurn * turn + (side > 0 ? 0.5F * kTurn : 0.0F);
    const Vec3 hip = {-0.2F, 0.08F * side, 0.98F};
    const Vec3 foot = {-0.06F + 0.17F * std::cos(angle), 0.11F * side,
                       0.34F + 0.17F * std::sin(angle)};
    addJointed(mesh, {hip, knee(hip, foot, kThigh, kShin), foot}, 0.08F, surfaces.trousers);
    const Vec3 shoulder = {0.12F, 0.19F * side, 1.42F};
    const Vec3 hand = {0.36F, 0.24F * side, 1.06F};
    addJointed(mesh, {shoulder, (shoulder + hand) * 0.5F + Vec3{0, 0.05F * side, -0.04F}, hand},
               0.05F, surfaces.coat);
  }
  addPost(mesh, {{-0.22F, 0, 0.95F}, {0.1F, 0, 1.45F}, 0.17F, 0.2F, 9}, surfaces.coat);
  addBall(mesh, {0.11F, 0, 1.44F}, {0.16F, 0.2F, 0.1F}, surfaces.coat);
  addBall(mesh, {0.22F, 0, 1.63F}, {0.11F, 0.08F, 0.13F}, surfaces.skin);
  addBall(mesh, {0.2F, 0, 1.7F}, {0.14F, 0.1F, 0.09F}, surfaces.metal);
  return mesh;
}

std::uint32_t addPrototype(World& world, Mesh mesh) {
  world.prototypes.push_back(std::move(mesh));
  return static_cast<std::uint32_t>(world.prototypes.size() - 1);
}

}  // namespace

std::vector<std::uint32_t> addWalkers(World& world) {
  const PersonSurfaces surfaces = addPersonSurfaces(world);
  std::vector<std::uint32_t> postures;
  for (int i = 0; i <= kGaitPhases; ++i) {
    const float step =
        i == kStanding ? -1.0F : (static_cast<float>(i) + 0.5F) / static_cast<float>(kGaitPhases);
    postures.push_back(addPrototype(world, walker(surfaces, step)));
  }
  return postures;
}

std::vector<std::uint32_t> addCyclists(World& world) {
  const PersonSurfaces surfaces = addPersonSurfaces(world);
  std::vector<std::uint32_t> postures;
  postures.reserve(kPedalPhases);
  for (int i = 0; i < kPedalPhases; ++i) {
    postures.push_back(
        addPrototype(world, cyclist(surfaces, static_cast<float>(i) / kPedalPhases)));
  }
  return postures;
}

}  // namespace tolman::town
