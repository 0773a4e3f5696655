// SPDX-License-Identifier: BSD-3-Clause
// Facades with windows and doors, and roofs. u runs along the wall, v up from the ground.
#include "lanes.hpp"
#include "material.hpp"
#include "wide_lanes.hpp"

namespace tolman::town {
namespace {

/// Points of the wall with the extents of their pixels, m.
struct WallPoints {
  Eight u;
  Eight v;
  Eight eu;
  Eight ev;
};

struct Boxes {
  Eight left;
  Eight right;
  Eight low;
  Eight high;
};

TOLMAN_INLINE Eight cover(const Boxes& box, const WallPoints& at) {
  return filteredPulse(box.left, box.right, at.u, at.eu) *
         filteredPulse(box.low, box.high, at.v, at.ev);
}

TOLMAN_INLINE Boxes shrunk(const Boxes& box, float by) {
  return {box.left + by, box.right - by, box.low + by, box.high - by};
}

TOLMAN_INLINE Eight bricks(const WallPoints& at, std::uint32_t seed, Eight footprint) {
  constexpr float kLength = 0.25F;
  constexpr float kHeight = 0.075F;
  constexpr float kJoint = 0.012F;
  const Eight visible = survives(0.16F, footprint);
  const auto row_tone = [&](EightInts row) TOLMAN_INLINE_LAMBDA {
    // Every other row is shifted by half a brick.
    const Eight u = at.u + select((row & 1) == 0, 0, kLength / 2);
    const EightWords in_row = hash(words(row), seed);
    const auto tone = [&](EightInts column) TOLMAN_INLINE_LAMBDA {
      return between(hash(words(column), in_row), -0.3F, 0.3F);
    };
    return larger(visible * filteredCells(kLength, u, at.eu, tone),
                  0.5F * filteredStripes(kLength, kJoint, u, at.eu));
  };
  const Eight tone = filteredCells(kHeight, at.v, at.ev, row_tone);
  return larger(tone, 0.5F * filteredStripes(kHeight, kJoint, at.v, at.ev));
}

/// What is behind the panes: a dark room, a curtain, or a shutter before either.
TOLMAN_INLINE Eight behindPanes(const Boxes& glass, const WallPoints& at, EightWords h) {
  Eight inside = between(hash(h, 3), 0.02F, 0.1F);
  const EightInts curtain = unit(hash(h, 4)) < 0.35F;
  if (any(curtain)) {  // brighter, with folds
    inside = select(curtain, 0.22F + 0.1F * filteredStripes(0.16F, 0.08F, at.u, at.eu), inside);
  }
  const EightInts shutter = unit(hash(h, 5)) < 0.3F;
  if (any(shutter)) {
    const Eight down = between(hash(h, 6), 0.25F, 1.0F) * (glass.high - glass.low);
    const Eight slats = 0.5F - 0.2F * filteredStripes(0.06F, 0.02F, at.v, at.ev);
    const Eight share = filteredStep(glass.high - down, at.v, at.ev);
    inside += select(shutter, (slats - inside) * share, Eight{});
  }
  return inside;
}

/// Albedo of a window with frame and panes, some with curtain or shutter.
TOLMAN_INLINE Eight window(const Boxes& opening, const WallPoints& at, Eight wall, EightWords h) {
  const Boxes sill = {opening.left - 0.1F, opening.right + 0.1F, opening.low - 0.1F, opening.low};
  const Eight in_opening = cover(opening, at);
  const Eight in_sill = cover(sill, at);
  if (!any((in_opening > 0) | (in_sill > 0))) return wall;  // bare wall between windows
  const Boxes glass = shrunk(opening, 0.09F);
  const Eight in_glass = cover(glass, at);
  const Eight middle = 0.5F * (opening.left + opening.right);
  const Eight bar = cover({middle - 0.04F, middle + 0.04F, glass.low, glass.high}, at);
  const Eight frame_tone = select(unit(hash(h, 7)) < 0.75F, 0.72F, 0.16F);
  const Eight inside = behindPanes(glass, at, h);
  Eight tone = wall + in_opening * (frame_tone - wall);
  tone += in_glass * (inside - frame_tone) + bar * (frame_tone - inside) * 0.9F;
  return tone + in_sill * (0.5F - wall);
}

TOLMAN_INLINE Eight door(const Boxes& opening, const WallPoints& at, Eight wall, EightWords h) {
  const Eight leaf = between(h, 0.08F, 0.5F);
  const Boxes panel = shrunk(opening, 0.25F);
  return wall + cover(opening, at) * (leaf - wall) + cover(panel, at) * (0.6F * leaf - leaf);
}

/// The windows or doors nearest to the points, in columns, in bays of equal width.
struct Openings {
  EightInts is_door;
  EightInts is_window;
  Boxes box;
  EightWords seed;
};

TOLMAN_INLINE Openings openingsAt(const Surface& surface, const WallPoints& at,
                                  std::uint32_t seed) {
  const float wanted = between(hash(seed, 11), 2.0F, 3.6F);
  const float bays = std::max(1.0F, floorOf(surface.width / wanted));
  const float bay = surface.width / bays;
  const Eight column = clamped(floorOf(at.u / bay), 0, bays - 1);
  const float storeys = std::max(1.0F, floorOf(surface.height / kStorey));
  const Eight storey = clamped(floorOf(at.v / kStorey), 0, storeys - 1);
  const EightWords h = hash(words(truncated(column)), words(truncated(storey)), seed);
  const float half = 0.5F * std::min(between(hash(seed, 12), 0.9F, 1.7F), 0.7F * bay);
  const Eight centre = (column + 0.5F) * bay;
  const Eight floor = storey * kStorey;
  const float sill = between(hash(seed, 13), 0.75F, 1.05F);
  const EightInts some = unit(h) >= 0.1F;  // other bays have no opening
  const EightInts door = some & (storey < 0.5F) & (unit(hash(h, 1)) < 1.2F / bays);
  Openings result = {
      door, some & ~door, {centre - half, centre + half, floor + sill, floor + 2.4F}, h};
  if (any(door)) {
    const Boxes leaf = {centre - 0.55F, centre + 0.55F, eight(0.05F), eight(2.15F)};
    result.box = {select(door, leaf.left, result.box.left),
                  select(door, leaf.right, result.box.right),
                  select(door, leaf.low, result.box.low), select(door, leaf.high, result.box.high)};
    result.seed = door ? hash(h, 2) : h;
  }
  return result;
}

TOLMAN_INLINE Eight openings(const Surface& surface, const WallPoints& at, Eight wall,
                             std::uint32_t seed) {
  const Openings nearest = openingsAt(surface, at, seed);
  Eight tone = wall;
  if (any(nearest.is_window)) {
    tone = select(nearest.is_window, window(nearest.box, at, wall, nearest.seed), tone);
  }
  if (any(nearest.is_door)) {
    tone = select(nearest.is_door, door(nearest.box, at, wall, nearest.seed), tone);
  }
  return tone;
}

TOLMAN_INLINE WallPoints wallPoints(const Surface& surface, const SurfaceHits& hits) {
  const Vec3s local = hits.point - vec3s(surface.origin);
  return {dot(local, vec3s(surface.axis_u)), dot(local, vec3s(surface.axis_v)),
          hits.extent(surface.axis_u), hits.extent(surface.axis_v)};
}

TOLMAN_INLINE Eight facade(const Surface& surface, const SurfaceHits& hits) {
  const WallPoints at = wallPoints(surface, hits);
  const Eight footprint = hits.footprint();
  const std::uint32_t seed = surface.seed;
  const bool of_brick = unit(hash(seed, 21)) < 0.3F;
  const Eight dirt = fractal2(at.u, at.v, 2.5F, 4, footprint, seed);
  // The roughness of plaster is the only texture of a near white wall.
  const Eight texture = of_brick ? bricks(at, seed, footprint)
                                 : 0.24F * fractal2(at.u, at.v, 0.09F, 2, footprint, seed + 3);
  Eight wall = surface.tone * (of_brick ? 0.6F : 1.0F) * larger(1 + 0.32F * dirt + texture, 0.2F);
  const float base = between(hash(seed, 22), 0.3F, 0.9F);  // m, a darker plinth
  wall *= 1 - 0.35F * (1 - filteredStep(base, at.v, at.ev));
  return openings(surface, at, wall, seed);
}

TOLMAN_INLINE Eight roof(const Surface& surface, const SurfaceHits& hits) {
  const Vec3s local = hits.point - vec3s(surface.origin);
  const Eight u = dot(local, vec3s(surface.axis_u));
  const Eight v = dot(local, vec3s(surface.axis_v));
  const Eight rows = filteredStripes(0.34F, 0.08F, v, hits.extent(surface.axis_v));
  const Eight tiles = filteredStripes(0.24F, 0.06F, u, hits.extent(surface.axis_u));
  const Eight moss = fractal2(u, v, 1.9F, 4, hits.footprint(), surface.seed);
  return surface.tone * larger(1 + 0.7F * moss - 0.5F * larger(rows, 0.6F * tiles), 0.15F);
}

}  // namespace

TOLMAN_WIDE_LANES
void litWindows(const Surface& surface, const SurfaceHits& hits, Eight& result) {
  constexpr float kLit = 0.25F;  // share of the windows
  const WallPoints at = wallPoints(surface, hits);
  const Openings nearest = openingsAt(surface, at, surface.seed);
  const EightInts lit = nearest.is_window & (unit(hash(nearest.seed, 8)) < kLit);
  const Eight glow =
      cover(shrunk(nearest.box, 0.09F), at) * between(hash(nearest.seed, 9), 0.4F, 1);
  result = select(lit, glow, Eight{});
}

TOLMAN_WIDE_LANES
void buildingAlbedos(const Surface& surface, const SurfaceHits& hits, Eight& result) {
  result = surface.material == Material::Roof ? roof(surface, hits) : facade(surface, hits);
}

}  // namespace tolman::town
