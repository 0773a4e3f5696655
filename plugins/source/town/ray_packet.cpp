// SPDX-License-Identifier: BSD-3-Clause
#include "ray_packet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dispatch.hpp"
#include "material_weather.hpp"
#include "noise.hpp"

namespace tolman::town {
namespace {

// From this distance on, m, pixels are wider than clumps of leaves and average lit and shaded ones.
constexpr float kClumpsMerge = 25;
constexpr float kClumpsMerged = 45;

/// Displacement of leaves by the wind, m; each clump has its own phase.
Vec3 flutter(const Light& light, const SurfaceHit& hit) {
  constexpr float kReach = 0.004F;  // m in a wind of 1 m/s
  const float phase = 7 * hit.point.x + 5 * hit.point.y + 6 * hit.point.z;
  const float reach = kReach * light.wind;
  const float t = light.seconds;
  return {reach * std::sin(9.1F * t + phase), reach * std::sin(7.7F * t + 1.3F * phase + 2),
          0.5F * reach * std::sin(11.3F * t + phase + 4)};
}

}  // namespace

/// Intersection of one ray of the packet.
struct RayPacket::Meeting {
  bool hit = false;
  float lit = 0;  // share that is lit by the sun
  float t = 0;
  Vec3 point;   // town axes
  Vec3 normal;  // town axes, unit, towards the camera
  Scene::Owner owner = {0, nullptr};
  std::uint32_t instance = 0;
};

TOLMAN_TOWN_DISPATCH [[gnu::flatten]] void RayPacket::trace(
    std::array<Meeting, kRaysPerPacket>& meetings) {
  alignas(32) std::array<int, kRaysPerPacket> valid{};
  RTCRayHit8 rays;
  for (int i = 0; i < kRaysPerPacket; ++i) {
    const auto used = static_cast<std::size_t>(std::min(i, count_ - 1));
    const Vec3& from = origins_[used];
    const Vec3& d = directions_[used];
    valid[static_cast<std::size_t>(i)] = i < count_ ? -1 : 0;
    rays.ray.org_x[i] = from.x;
    rays.ray.org_y[i] = from.y;
    rays.ray.org_z[i] = from.z;
    rays.ray.dir_x[i] = d.x;
    rays.ray.dir_y[i] = d.y;
    rays.ray.dir_z[i] = d.z;
    rays.ray.tnear[i] = 0.05F;
    rays.ray.tfar[i] = std::numeric_limits<float>::infinity();
    rays.ray.time[i] = 0;
    rays.ray.mask[i] = ~0U;
    rays.ray.flags[i] = 0;
    rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  around_.scene->intersect(valid.data(), rays);
  for (int i = 0; i < count_; ++i) {
    Meeting& meeting = meetings[static_cast<std::size_t>(i)];
    meeting.hit = rays.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
    if (!meeting.hit) continue;
    const Vec3& d = directions_[static_cast<std::size_t>(i)];
    meeting.t = rays.ray.tfar[i];
    meeting.point = origins_[static_cast<std::size_t>(i)] + d * meeting.t;
    meeting.instance = rays.hit.instID[0][i];
    meeting.owner = around_.scene->ownerOf(meeting.instance, rays.hit.primID[i]);
    Vec3 normal = normalised({rays.hit.Ng_x[i], rays.hit.Ng_y[i], rays.hit.Ng_z[i]});
    if (meeting.owner.instance) normal = meeting.owner.instance->placement.rotate(normal);
    meeting.normal = dot(normal, d) > 0 ? normal * -1 : normal;
  }
}

TOLMAN_TOWN_DISPATCH [[gnu::flatten]] void RayPacket::castShadows(
    std::array<Meeting, kRaysPerPacket>& meetings) const {
  const Vec3& to_sun = around_.light->to_sun;
  if (around_.light->sun <= 0) return;
  alignas(32) std::array<int, kRaysPerPacket> valid{};
  RTCRay8 rays;
  for (int i = 0; i < kRaysPerPacket; ++i) {
    const Meeting& meeting = meetings[static_cast<std::size_t>(i)];
    const bool faces = i < count_ && meeting.hit && dot(meeting.normal, to_sun) > 0 &&
                       !(meeting.t > kClumpsMerged && isFoliage(meeting));
    valid[static_cast<std::size_t>(i)] = faces ? -1 : 0;
    const Vec3 from = meeting.point + meeting.normal * (2e-3F + 1e-4F * meeting.t);
    rays.org_x[i] = from.x;
    rays.org_y[i] = from.y;
    rays.org_z[i] = from.z;
    rays.dir_x[i] = to_sun.x;
    rays.dir_y[i] = to_sun.y;
    rays.dir_z[i] = to_sun.z;
    rays.tnear[i] = 0;
    rays.tfar[i] = 300;
    rays.time[i] = 0;
    rays.mask[i] = ~0U;
    rays.flags[i] = 0;
  }
  if (std::all_of(valid.begin(), valid.end(), [](int v) { return v == 0; })) return;
  around_.scene->occlude(valid.data(), rays);
  for (std::size_t i = 0; i < kRaysPerPacket; ++i) {
    meetings[i].lit = valid[i] != 0 && rays.tfar[i] >= 0 ? 1.0F : 0.0F;
  }
}

/// The point in the axes of the surface's pattern, with the footprint of the pixel.
SurfaceHit RayPacket::hitOf(const Meeting& meeting, const Vec3& direction) const {
  const Surface& surface = around_.scene->surface(meeting.owner.surface);
  // The footprint on the tangent plane; its length at grazing angles is limited.
  float slope = dot(meeting.normal, direction);
  slope = std::min(slope, -0.01F * norm(direction));
  const auto onPlane = [&](const Vec3& pixel) {
    return (pixel - direction * (dot(meeting.normal, pixel) / slope)) * meeting.t;
  };
  SurfaceHit hit;
  hit.point = meeting.point;
  hit.normal = meeting.normal;
  hit.dx = onPlane(around_.pixel_x);
  hit.dy = onPlane(around_.pixel_y);
  hit.seed = surface.seed;
  if (const MeshInstance* instance = meeting.owner.instance) {
    const Placement& placement = instance->placement;
    hit.point = placement.toLocal(meeting.point);
    hit.normal = placement.unrotate(meeting.normal);
    hit.dx = placement.unrotate(hit.dx) * (1 / placement.scale);
    hit.dy = placement.unrotate(hit.dy) * (1 / placement.scale);
    hit.seed = hash(surface.seed, instance->seed);
  }
  return hit;
}

TOLMAN_TOWN_DISPATCH [[gnu::flatten]] Shaded RayPacket::shadeOne(const Meeting& meeting,
                                                                 const Vec3& direction) const {
  if (!meeting.hit) {
    return {around_.light->fromSky(direction, norm(around_.pixel_x)), 0, 0};
  }
  const Surface& surface = around_.scene->surface(meeting.owner.surface);
  SurfaceHit hit = hitOf(meeting, direction);
  // Leaves have all orientations, so the facets of the lump that represents them must not be
  // visible.
  const bool foliage = surface.material == Material::Leaves;
  const Vec3 facing = foliage
                          ? meeting.normal * 0.3F + around_.light->to_sun * 0.35F + Vec3{0, 0, 0.3F}
                          : meeting.normal;
  float lit = meeting.lit;
  if (foliage) lit += (0.5F - lit) * smoothstep(kClumpsMerge, kClumpsMerged, meeting.t);
  const float light = around_.light->onto(facing, lit);
  if (foliage && around_.light->wind > 0) hit.point = hit.point + flutter(*around_.light, hit);
  float tone = albedo(surface, hit, *around_.plan);
  float radiance = tone * light;
  if (around_.light->wet > 0 || around_.light->snow > 0 || around_.light->puddles > 0) {
    tone = weatheredAlbedo(tone, surface, meeting.point, meeting.normal, hit.footprint(),
                           *around_.light, *around_.plan);
    radiance = tone * light;
  }
  if (around_.light->lamps > 0) radiance += tone * lampLight(meeting) + glow(meeting, hit);
  return {around_.light->through(radiance, meeting.t * norm(direction)), meeting.t,
          seenAs(meeting)};
}

float RayPacket::lampLight(const Meeting& meeting) const {
  constexpr float kOncoming = 0.3F;  // low beams of other cars hardly light what the camera sees
  const Light& light = *around_.light;
  float sum = headlightsOnto(light.headlights, meeting.point, meeting.normal);
  if (around_.lamps != nullptr) sum += around_.lamps->onto(meeting.point, meeting.normal);
  for (int i = 0; i < light.oncoming_count; ++i) {
    sum += kOncoming * headlightsOnto(light.oncoming[static_cast<std::size_t>(i)], meeting.point,
                                      meeting.normal);
  }
  return light.lamps * sum;
}

/// Emitted radiance: of heads of lamps, lit windows, lamps of cars.
float RayPacket::glow(const Meeting& meeting, const SurfaceHit& hit) const {
  constexpr float kLamp = 6;
  constexpr float kWindow = 0.12F;
  const Surface& surface = around_.scene->surface(meeting.owner.surface);
  if (surface.material == Material::Facade) {
    return around_.light->lamps * kWindow * litWindows(surface, hit);
  }
  const MeshInstance* instance = meeting.owner.instance;
  if (surface.material == Material::Body && instance != nullptr && instance->shines) {
    return around_.light->lamps * carLamps(hit);
  }
  const bool shines = surface.material == Material::Plain && around_.lamps != nullptr &&
                      around_.lamps->isHead(meeting.point);
  return shines ? around_.light->lamps * kLamp : 0;
}

/// Share of light that the point reflects like a mirror.
float RayPacket::mirrorShare(const Meeting& meeting, const Vec3& direction) const {
  const Vec3 way = normalised(direction);
  const Light& light = *around_.light;
  const Surface& surface = around_.scene->surface(meeting.owner.surface);
  float share = mirroredShare(surface, meeting.point, meeting.normal, way, light);
  if (light.glass > 0) {
    const bool may_be_glass =
        surface.material == Material::Facade || surface.material == Material::Body;
    const float glass = may_be_glass ? glassShare(surface, hitOf(meeting, direction)) : 0;
    share += light.glass * mirroredByGlass(glass, meeting.normal, way);
  }
  return share;
}

/// Adds reflections of wet ground and glass. For reflected rays the ground is dry.
void RayPacket::mirror(const std::array<Meeting, kRaysPerPacket>& meetings,
                       std::array<Shaded, kRaysPerPacket>& shaded) const {
  Light dry = *around_.light;
  dry.wet = dry.glass = dry.puddles = 0;
  Surroundings around = around_;
  around.light = &dry;
  RayPacket mirrored(around);
  std::array<std::size_t, kRaysPerPacket> owners{};
  std::array<float, kRaysPerPacket> shares{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
    const Meeting& meeting = meetings[i];
    if (!meeting.hit) continue;
    const float share = mirrorShare(meeting, directions_[i]);
    if (share < 0.01F) continue;
    const auto at = static_cast<std::size_t>(mirrored.size());
    owners[at] = i;
    shares[at] = share;
    const float along = dot(directions_[i], meeting.normal);
    mirrored.add(meeting.point + meeting.normal * 0.01F,
                 directions_[i] - meeting.normal * (2 * along));
  }
  const auto count = static_cast<std::size_t>(mirrored.size());
  const auto seen = mirrored.shade();
  for (std::size_t i = 0; i < count; ++i) {
    float& radiance = shaded[owners[i]].radiance;
    radiance += shares[i] * (seen[i].radiance - radiance);
  }
}

bool RayPacket::isFoliage(const Meeting& meeting) const {
  return around_.scene->surface(meeting.owner.surface).material == Material::Leaves;
}

std::uint32_t RayPacket::seenAs(const Meeting& meeting) const {
  const std::uint32_t thing = hash(meeting.owner.surface + 1, meeting.instance) << 3U;
  const std::uint32_t kind = isFoliage(meeting) ? kFoliage : (meeting.lit > 0 ? 1U : 0U);
  return thing | 4U | kind;  // never 0, which is the sky
}

std::array<Shaded, kRaysPerPacket> RayPacket::shade() {
  std::array<Shaded, kRaysPerPacket> result{};
  if (count_ == 0) return result;
  std::array<Meeting, kRaysPerPacket> meetings{};
  trace(meetings);
  castShadows(meetings);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
    result[i] = shadeOne(meetings[i], directions_[i]);
  }
  const Light& light = *around_.light;
  if (light.wet > 0 || light.glass > 0 || light.puddles > 0) mirror(meetings, result);
  count_ = 0;
  return result;
}

}  // namespace tolman::town
