// SPDX-License-Identifier: BSD-3-Clause
#include "ray_packet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lanes.hpp"
#include "light.hpp"
#include "material.hpp"
#include "wide_lanes.hpp"

namespace tolman::town {
namespace {

// From this distance on, m, pixels are wider than clumps of leaves and average lit and shaded ones.
constexpr float kClumpsMerge = 25;
constexpr float kClumpsMerged = 45;

}  // namespace

/// Intersections of eight rays of the packet.
struct RayPacket::Meetings {
  EightInts hit;
  EightInts foliage;
  EightInts placed;  ///< on an instance
  Eight lit;         ///< shares that are lit by the sun
  Eight t;
  Vec3s direction;
  Vec3s point;   ///< town axes
  Vec3s normal;  ///< town axes, unit, towards the camera
  EightWords seen;
  Placements placements;  ///< set if any lane is placed
  EightWords instance_seed;
  std::array<std::uint32_t, kLanes> surface;
  std::array<const MeshInstance*, kLanes> instance;
  std::array<std::uint32_t, kLanes> instance_index;
};

TOLMAN_WIDE_LANES
void RayPacket::meet(std::size_t group, Meetings& m) const {
  const auto& [ray, found] = rays_;
  const std::size_t first = group * kLanes;
  alignas(32) std::array<std::uint32_t, kLanes> hit{};
  alignas(32) std::array<std::uint32_t, kLanes> foliage{};
  alignas(32) std::array<std::uint32_t, kLanes> placed{};
  alignas(32) std::array<std::uint32_t, kLanes> seeds{};
  alignas(32) std::array<std::uint32_t, kLanes> instances{};
  m.surface = {};
  m.instance = {};
  m.instance_index.fill(kNoInstance);
  for (std::size_t i = 0; i < kLanes; ++i) {
    if (found.geomID[first + i] == RTC_INVALID_GEOMETRY_ID) continue;
    instances[i] = found.instID[0][first + i];
    const Scene::Owner owner = around_.scene->ownerOf(instances[i], found.primID[first + i]);
    hit[i] = ~0U;
    m.surface[i] = owner.number;
    m.instance[i] = owner.instance;
    m.instance_index[i] = instances[i];
    if (owner.surface->material == Material::Leaves) foliage[i] = ~0U;
    if (owner.instance == nullptr) continue;
    placed[i] = ~0U;
    seeds[i] = owner.instance->seed;
  }
  const auto load = [](const std::array<std::uint32_t, kLanes>& from) TOLMAN_INLINE_LAMBDA {
    EightInts value;
    std::memcpy(&value, from.data(), sizeof value);
    return value;
  };
  m.hit = load(hit);
  m.foliage = load(foliage);
  m.placed = load(placed);
  m.instance_seed = words(load(seeds));
  m.seen = hash(words(load(m.surface)) + 1, words(load(instances))) << 3;
  m.lit = Eight{};
  m.direction = {loadEight(ray.dir_x + first), loadEight(ray.dir_y + first),
                 loadEight(ray.dir_z + first)};
  // A ray without a hit counts as one that ends at once, so that what is computed of it is finite.
  m.t = select(m.hit, loadEight(ray.tfar + first), Eight{});
  const Vec3s origin = {loadEight(ray.org_x + first), loadEight(ray.org_y + first),
                        loadEight(ray.org_z + first)};
  m.point = origin + m.direction * m.t;
  const Vec3s up = vec3s({0, 0, 1});
  const Vec3s across = {loadEight(found.Ng_x + first), loadEight(found.Ng_y + first),
                        loadEight(found.Ng_z + first)};
  Vec3s normal = normalised(select(m.hit, across, up));
  if (any(m.placed)) {
    for (std::size_t i = 0; i < kLanes; ++i) {
      m.placements.set(i, m.instance[i] ? m.instance[i]->placement : Placement{});
    }
    normal = m.placements.rotate(normal);
  }
  m.normal = normal * select(dot(normal, m.direction) > 0, -1.0F, 1.0F);
}

TOLMAN_WIDE_LANES
void RayPacket::castShadows(Meetings& m) const {
  const Vec3s to_sun = vec3s(around_.light->to_sun);
  const EightInts merged = m.foliage & (m.t > kClumpsMerged);
  const EightInts faces = m.hit & (dot(m.normal, to_sun) > 0) & ~merged;
  m.lit = select(faces, 1.0F, 0.0F);
  const Vec3s from = m.point + m.normal * (2e-3F + 1e-4F * m.t);
  EightInts by_fixed;
  EightInts by_placed;
  around_.scene->shadows().look(from, by_fixed, by_placed);
  by_fixed &= faces;
  by_placed &= faces;
  if (!any(by_fixed | by_placed)) return;
  RTCRay8 rays;
  store(from.x, rays.org_x);
  store(from.y, rays.org_y);
  store(from.z, rays.org_z);
  store(to_sun.x, rays.dir_x);
  store(to_sun.y, rays.dir_y);
  store(to_sun.z, rays.dir_z);
  for (int i = 0; i < kLanes; ++i) {
    rays.tnear[i] = 0;
    rays.tfar[i] = 300;
    rays.time[i] = 0;
    rays.mask[i] = ~0U;
    rays.flags[i] = 0;
  }
  alignas(32) std::array<std::array<int, kLanes>, 2> valid;
  std::memcpy(valid[0].data(), &by_fixed, sizeof by_fixed);
  std::memcpy(valid[1].data(), &by_placed, sizeof by_placed);
  around_.scene->occlude(valid[0].data(), valid[1].data(), rays);
  m.lit = select(faces & (loadEight(rays.tfar) >= 0), 1.0F, 0.0F);
}

/// Calls body(surface, mask) for each surface that rays meet: usually one.
template <class Body>
TOLMAN_INLINE void RayPacket::forEachSurface(const Meetings& m, const Body& body) const {
  EightWords own;
  std::memcpy(&own, m.surface.data(), sizeof own);
  EightInts left = m.hit;
  while (any(left)) {
    int i = 0;
    while (left[i] == 0) ++i;
    const std::uint32_t index = m.surface[static_cast<std::size_t>(i)];
    const EightInts mask = left & (own == index);
    body(around_.scene->surface(index), mask);
    left &= ~mask;
  }
}

/// The points in the axes of their surfaces' patterns, with the footprints of their pixels; without
/// seeds, which need the surface.
TOLMAN_INLINE SurfaceHits RayPacket::hitsOf(const Meetings& m) const {
  // The footprint on the tangent plane; its length at grazing angles is limited.
  const Eight slope = smaller(dot(m.normal, m.direction), -0.01F * norm(m.direction));
  const auto onPlane = [&](const Vec3& of) TOLMAN_INLINE_LAMBDA {
    const Vec3s pixel = vec3s(of);
    return (pixel - m.direction * (dot(m.normal, pixel) / slope)) * m.t;
  };
  SurfaceHits hits = {m.point, m.normal, onPlane(around_.pixel_x), onPlane(around_.pixel_y), {}};
  if (!any(m.placed)) return hits;
  const Placements& placements = m.placements;
  const Eight shrinking = placements.shrinking();
  hits.point = placements.toLocal(m.point);
  hits.normal = placements.unrotate(m.normal);
  hits.dx = placements.unrotate(hits.dx) * shrinking;
  hits.dy = placements.unrotate(hits.dy) * shrinking;
  return hits;
}

TOLMAN_WIDE_LANES
void RayPacket::shadeGroup(const Meetings& m, Shaded* shaded) const {
  const Light& light = *around_.light;
  Eight radiance = {};
  if (any(m.hit)) {
    SurfaceHits hits = hitsOf(m);
    Eight tone = {};
    forEachSurface(m, [&](const Surface& surface, EightInts mask) TOLMAN_INLINE_LAMBDA {
      const EightWords seed = surface.seed - EightWords{};
      hits.seed = m.placed ? hash(seed, m.instance_seed) : seed;
      Eight value;
      albedos(surface, hits, *around_.plan, value);
      tone = select(mask, value, tone);
    });
    // Leaves have all orientations, so the facets of the lump that represents them must not be
    // visible.
    const Vec3s of_leaves = m.normal * eight(0.3F) + vec3s(light.to_sun * 0.35F + Vec3{0, 0, 0.3F});
    const Vec3s facing = select(m.foliage, of_leaves, m.normal);
    const Eight merged = m.lit + (0.5F - m.lit) * smoothstep(kClumpsMerge, kClumpsMerged, m.t);
    const Eight on = lightOnto(light, facing, select(m.foliage, merged, m.lit));
    if (light.wet > 0 || light.snow > 0) weather(m, hits, tone);
    radiance = tone * on;
    if (light.lamps > 0) addLamps(m, hits, tone, radiance);
    radiance = lightThrough(light, radiance, m.t * norm(m.direction));
  }
  if (!all(m.hit)) {
    const float spread = norm(around_.pixel_x);
    radiance = select(m.hit, radiance, lightFromSky(light, m.direction, spread));
  }
  const EightWords lit = words(m.lit > 0) & 1U;
  const EightWords kind = m.foliage ? kFoliage - EightWords{} : lit;
  const EightWords seen = (m.seen | 4U | kind) & words(m.hit);  // 0 only for the sky
  for (int i = 0; i < kLanes; ++i) {
    shaded[i] = {radiance[i], m.t[i], seen[i], m.instance_index[static_cast<std::size_t>(i)]};
  }
}

void RayPacket::weather(const Meetings& m, const SurfaceHits& hits, Eight& tone) const {
  const Eight footprint = hits.footprint();
  for (int i = 0; i < kLanes; ++i) {
    if (m.hit[i] == 0) continue;
    const Surface& surface = around_.scene->surface(m.surface[static_cast<std::size_t>(i)]);
    tone[i] = weatheredAlbedo(tone[i], surface, lane(m.point, i), lane(m.normal, i), footprint[i],
                              *around_.light, *around_.plan);
  }
}

/// Adds the light of lamps on the points, and what shines by itself: heads of lamps and windows.
void RayPacket::addLamps(const Meetings& m, const SurfaceHits& hits, const Eight& tone,
                         Eight& radiance) const {
  constexpr float kLamp = 6;
  constexpr float kWindow = 0.12F;
  const float lamps = around_.light->lamps;
  for (int i = 0; i < kLanes; ++i) {
    if (m.hit[i] == 0) continue;
    const Vec3 point = lane(m.point, i);
    const Vec3 normal = lane(m.normal, i);
    float sum = headlightsOnto(around_.light->headlights, point, normal);
    if (around_.lamps != nullptr) sum += around_.lamps->onto(point, normal);
    radiance[i] += tone[i] * (lamps * sum);
  }
  forEachSurface(m, [&](const Surface& surface, EightInts mask) TOLMAN_INLINE_LAMBDA {
    if (surface.material == Material::Facade) {
      Eight windows;
      litWindows(surface, hits, windows);
      radiance += select(mask, lamps * kWindow * windows, Eight{});
      return;
    }
    if (surface.material != Material::Plain || around_.lamps == nullptr) return;
    for (int i = 0; i < kLanes; ++i) {
      if (mask[i] != 0 && around_.lamps->isHead(lane(m.point, i))) radiance[i] += lamps * kLamp;
    }
  });
}

std::array<Shaded, kRaysPerPacket> RayPacket::shade() {
  std::array<Shaded, kRaysPerPacket> result;
  if (count_ == 0) return {};
  const auto count = static_cast<std::size_t>(count_);
  alignas(64) std::array<int, kRaysPerPacket> valid{};
  auto& [ray, hit] = rays_;
  for (int i = 0; i < kRaysPerPacket; ++i) {
    const int of = std::min(i, count_ - 1);
    valid[static_cast<std::size_t>(i)] = of == i ? -1 : 0;
    // The lanes behind the last ray repeat it, so that they compute something finite.
    set(i, {ray.org_x[of], ray.org_y[of], ray.org_z[of]},
        {ray.dir_x[of], ray.dir_y[of], ray.dir_z[of]});
    ray.tnear[i] = 0.05F;
    ray.tfar[i] = std::numeric_limits<float>::infinity();
    ray.time[i] = 0;
    ray.mask[i] = ~0U;
    ray.flags[i] = 0;
    hit.geomID[i] = hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  around_.scene->intersect(valid.data(), rays_);
  for (std::size_t g = 0; g * kLanes < count; ++g) {
    Meetings meetings;
    meet(g, meetings);
    if (around_.light->sun > 0) castShadows(meetings);
    shadeGroup(meetings, result.data() + g * kLanes);
  }
  count_ = 0;
  return result;
}

}  // namespace tolman::town
