// SPDX-License-Identifier: BSD-3-Clause
// Facades with windows and doors, and roofs. u runs along the wall, v up from the ground.
#include "dispatch.hpp"
#include "material.hpp"
#include "noise.hpp"
#include "pattern.hpp"

namespace tolman::town {
namespace {

constexpr float kStorey = 2.9F;  // m

/// A point of the wall with the extents of the pixel, m.
struct WallPoint {
  float u;
  float v;
  float eu;
  float ev;
};

struct Box {
  float left;
  float right;
  float low;
  float high;
};

float cover(const Box& box, const WallPoint& at) {
  return filteredPulse(box.left, box.right, at.u, at.eu) *
         filteredPulse(box.low, box.high, at.v, at.ev);
}

Box shrunk(const Box& box, float by) {
  return {box.left + by, box.right - by, box.low + by, box.high - by};
}

float bricks(const WallPoint& at, std::uint32_t seed, float footprint) {
  constexpr float kLength = 0.25F;
  constexpr float kHeight = 0.075F;
  constexpr float kJoint = 0.012F;
  const float visible = survives(0.16F, footprint);
  // Every other row is shifted by half a brick.
  const float tone = filteredCells(kHeight, at.v, at.ev, [&](int row) {
    const float u = at.u + (row % 2 == 0 ? 0 : kLength / 2);
    const float single = visible * filteredCells(kLength, u, at.eu, [&](int column) {
                           return between(hash(static_cast<std::uint32_t>(column),
                                               static_cast<std::uint32_t>(row), seed),
                                          -0.3F, 0.3F);
                         });
    return std::max(single, 0.5F * filteredStripes(kLength, kJoint, u, at.eu));
  });
  return std::max(tone, 0.5F * filteredStripes(kHeight, kJoint, at.v, at.ev));
}

/// Albedo of a window with frame and panes, some with curtain or shutter.
float window(const Box& opening, const WallPoint& at, float wall, std::uint32_t h) {
  const Box glass = shrunk(opening, 0.09F);
  const float in_opening = cover(opening, at);
  const float in_glass = cover(glass, at);
  const float middle = 0.5F * (opening.left + opening.right);
  const float bar = cover({middle - 0.04F, middle + 0.04F, glass.low, glass.high}, at);
  const float frame_tone = unit(hash(h, 7)) < 0.75F ? 0.72F : 0.16F;
  float pane = between(hash(h, 3), 0.02F, 0.1F);
  if (unit(hash(h, 4)) < 0.35F) {  // curtain: brighter, with folds
    pane = 0.22F + 0.1F * filteredStripes(0.16F, 0.08F, at.u, at.eu);
  }
  float inside = pane;
  if (unit(hash(h, 5)) < 0.3F) {  // shutter
    const float down = between(hash(h, 6), 0.25F, 1.0F) * (glass.high - glass.low);
    const float slats = 0.5F - 0.2F * filteredStripes(0.06F, 0.02F, at.v, at.ev);
    inside += (slats - pane) * filteredStep(glass.high - down, at.v, at.ev);
  }
  float tone = wall + in_opening * (frame_tone - wall);
  tone += in_glass * (inside - frame_tone) + bar * (frame_tone - inside) * 0.9F;
  const Box sill = {opening.left - 0.1F, opening.right + 0.1F, opening.low - 0.1F, opening.low};
  return tone + cover(sill, at) * (0.5F - wall);
}

float door(const Box& opening, const WallPoint& at, float wall, std::uint32_t h) {
  const float leaf = between(h, 0.08F, 0.5F);
  const Box panel = shrunk(opening, 0.25F);
  return wall + cover(opening, at) * (leaf - wall) + cover(panel, at) * (0.6F * leaf - leaf);
}

/// The window or door nearest to a point. Openings are in columns, in bays of equal width.
struct Opening {
  enum class Kind { None, Door, Window } kind = Kind::None;
  Box box = {};
  std::uint32_t seed = 0;
};

Opening openingAt(const Surface& surface, const WallPoint& at, std::uint32_t seed) {
  const float wanted = between(hash(seed, 11), 2.0F, 3.6F);
  const float bays = std::max(1.0F, floorOf(surface.width / wanted));
  const float bay = surface.width / bays;
  const float column = std::clamp(floorOf(at.u / bay), 0.0F, bays - 1);
  const float storeys = std::max(1.0F, floorOf(surface.height / kStorey));
  const float storey = std::clamp(floorOf(at.v / kStorey), 0.0F, storeys - 1);
  const std::uint32_t h =
      hash(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(storey), seed);
  if (unit(h) < 0.1F) return {};  // a bay without opening
  const float half = 0.5F * std::min(between(hash(seed, 12), 0.9F, 1.7F), 0.7F * bay);
  const float centre = (column + 0.5F) * bay;
  const float floor = storey * kStorey;
  if (storey < 0.5F && unit(hash(h, 1)) < 1.2F / bays) {
    return {Opening::Kind::Door, {centre - 0.55F, centre + 0.55F, 0.05F, 2.15F}, hash(h, 2)};
  }
  const float sill = between(hash(seed, 13), 0.75F, 1.05F);
  return {Opening::Kind::Window, {centre - half, centre + half, floor + sill, floor + 2.4F}, h};
}

float openings(const Surface& surface, const WallPoint& at, float wall, std::uint32_t seed) {
  const Opening opening = openingAt(surface, at, seed);
  if (opening.kind == Opening::Kind::None) return wall;
  return opening.kind == Opening::Kind::Door ? door(opening.box, at, wall, opening.seed)
                                             : window(opening.box, at, wall, opening.seed);
}

WallPoint wallPoint(const Surface& surface, const SurfaceHit& hit) {
  const Vec3 local = hit.point - surface.origin;
  return {dot(local, surface.axis_u), dot(local, surface.axis_v), hit.extent(surface.axis_u),
          hit.extent(surface.axis_v)};
}

float facade(const Surface& surface, const SurfaceHit& hit) {
  const WallPoint at = wallPoint(surface, hit);
  const float footprint = hit.footprint();
  const std::uint32_t seed = surface.seed;
  const bool of_brick = unit(hash(seed, 21)) < 0.3F;
  const float dirt = fractal2(at.u, at.v, 2.5F, 4, footprint, seed);
  // The roughness of plaster is the only texture of a near white wall.
  const float rough = fractal2(at.u, at.v, 0.09F, 2, footprint, seed + 3);
  const float texture = of_brick ? bricks(at, seed, footprint) : 0.24F * rough;
  float wall = surface.tone * (of_brick ? 0.6F : 1.0F);
  wall *= std::max(0.2F, 1 + 0.32F * dirt + texture);
  const float base = between(hash(seed, 22), 0.3F, 0.9F);  // m, a darker plinth
  wall *= 1 - 0.35F * (1 - filteredStep(base, at.v, at.ev));
  return openings(surface, at, wall, seed);
}

float roof(const Surface& surface, const SurfaceHit& hit) {
  const Vec3 local = hit.point - surface.origin;
  const float u = dot(local, surface.axis_u);
  const float v = dot(local, surface.axis_v);
  const float rows = filteredStripes(0.34F, 0.08F, v, hit.extent(surface.axis_v));
  const float tiles = filteredStripes(0.24F, 0.06F, u, hit.extent(surface.axis_u));
  const float moss = fractal2(u, v, 1.9F, 4, hit.footprint(), surface.seed);
  return surface.tone * std::max(0.15F, 1 + 0.7F * moss - 0.5F * std::max(rows, 0.6F * tiles));
}

}  // namespace

float litWindows(const Surface& surface, const SurfaceHit& hit) {
  constexpr float kLit = 0.25F;  // share of the windows
  const WallPoint at = wallPoint(surface, hit);
  const Opening opening = openingAt(surface, at, surface.seed);
  const bool is_lit = opening.kind == Opening::Kind::Window && unit(hash(opening.seed, 8)) < kLit;
  return is_lit ? cover(shrunk(opening.box, 0.09F), at) * between(hash(opening.seed, 9), 0.4F, 1)
                : 0;
}

float windowGlass(const Surface& surface, const SurfaceHit& hit) {
  const WallPoint at = wallPoint(surface, hit);
  const Opening opening = openingAt(surface, at, surface.seed);
  if (opening.kind != Opening::Kind::Window) return 0;
  return cover(shrunk(opening.box, 0.09F), at);  // shutters are inside
}

TOLMAN_TOWN_DISPATCH [[gnu::flatten]] float buildingAlbedo(const Surface& surface,
                                                           const SurfaceHit& hit) {
  return surface.material == Material::Roof ? roof(surface, hit) : facade(surface, hit);
}

}  // namespace tolman::town
