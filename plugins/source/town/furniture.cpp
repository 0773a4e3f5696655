// SPDX-License-Identifier: BSD-3-Clause
// Street furniture, lane markings, guard rails and the horizon.
#include "noise.hpp"
#include "objects.hpp"
#include "world.hpp"

namespace tolman::town {
namespace {

constexpr Vec3 kUp = {0, 0, 1};

void addPole(World& world, const Vec3& foot, float height, float radius, std::uint32_t surface) {
  addPost(world.fixed, {foot - kUp * 0.4F, foot + kUp * height, radius, 0.8F * radius, 8}, surface);
}

/// A board that faces along the street; its lower left corner is `up` m above the ground.
void addBoard(World& world, const Stand& stand, float up, float width, float height, float tone) {
  const Vec3 origin = stand.foot + kUp * up - stand.inward * (width / 2);
  const std::uint32_t board = world.addSurface({.material = Material::Board,
                                                .seed = stand.seed,
                                                .tone = tone,
                                                .origin = origin,
                                                .axis_u = stand.inward,
                                                .axis_v = kUp,
                                                .width = width,
                                                .height = height});
  addBox(world.fixed, origin - stand.along * 0.06F,
         {stand.inward * width, stand.along * 0.03F, kUp * height}, board);
}

/// Sides and top of a box over a plot, from a little below the ground.
void addPlotBox(World& world, const Plot& plot, double ground, float height,
                std::uint32_t surface) {
  const auto corner = [&](double along, double over) {
    Vec3 p = toVec3(plot.point(along, over), ground);
    p.z -= 0.6F;
    return p;
  };
  const Vec3 low = corner(-plot.half_length, -plot.half_depth);
  addBox(world.fixed, low,
         {corner(plot.half_length, -plot.half_depth) - low,
          corner(-plot.half_length, plot.half_depth) - low, kUp * (height + 0.6F)},
         surface);
}

/// `over` m to the left of a point of the centreline.
Eigen::Vector2d beside(const StreetPoint& p, double over) {
  return p.position + over * Eigen::Vector2d(-p.direction.y(), p.direction.x());
}

}  // namespace

void addLamp(World& world, const Stand& stand) {
  const std::uint32_t metal =
      world.addSurface({.seed = stand.seed, .tone = between(stand.seed, 0.06F, 0.4F)});
  const float height = between(hash(stand.seed, 1), 5, 8);
  addPole(world, stand.foot, height, 0.08F, metal);
  const Vec3 top = stand.foot + kUp * height;
  const Vec3 end = top + stand.inward * 1.3F + kUp * 0.25F;
  addPost(world.fixed, {top, end, 0.05F, 0.04F, 6}, metal);
  addBox(world.fixed, end - stand.along * 0.14F,
         {stand.inward * 0.7F, stand.along * 0.28F, kUp * 0.12F}, metal);
  world.lamp_heads.push_back(end + stand.inward * 0.35F + kUp * 0.06F);
}

void addSign(World& world, const Stand& stand) {
  addPole(world, stand.foot, 2.9F, 0.035F, world.addSurface({.seed = stand.seed, .tone = 0.35F}));
  const float size = between(hash(stand.seed, 2), 0.55F, 0.8F);
  addBoard(world, stand, 2.1F, size, size, between(hash(stand.seed, 3), 0.1F, 0.7F));
}

void addPoster(World& world, const Stand& stand) {
  const std::uint32_t posts = world.addSurface({.seed = stand.seed, .tone = 0.25F});
  for (const float side : {-1.2F, 1.2F}) {
    addPole(world, stand.foot + stand.inward * side, 3.3F, 0.07F, posts);
  }
  addBoard(world, stand, 1.2F, 3.0F, 2.2F, between(hash(stand.seed, 3), 0.2F, 0.55F));
}

void addFence(World& world, const Plot& plot, double ground, std::uint32_t seed) {
  const std::uint32_t boards = world.addSurface({.material = Material::Wood,
                                                 .seed = seed,
                                                 .tone = between(hash(seed, 1), 0.1F, 0.5F),
                                                 .origin = toVec3(plot.centre, ground),
                                                 .axis_u = toVec3(plot.axis, 0)});
  addPlotBox(world, plot, ground, between(hash(seed, 2), 0.8F, 1.7F), boards);
}

void addHedge(World& world, const Plot& plot, double ground, std::uint32_t seed) {
  const float tone = between(hash(seed, 1), 0.09F, 0.18F);
  addPlotBox(world, plot, ground, between(hash(seed, 2), 0.8F, 1.9F),
             world.addSurface({.material = Material::Leaves, .seed = seed, .tone = tone}));
}

void addLaneMarkings(World& world, const StreetPlan& plan, std::uint32_t seed) {
  constexpr double kHalfWidth = 0.06;  // m
  constexpr int kDash = 3;             // m
  constexpr int kPeriod = 9;           // m
  constexpr float kThickness = 0.012F;
  const std::uint32_t surface =
      world.addSurface({.material = Material::Paint, .seed = seed, .tone = 0.5F});
  const auto on_road = [&](const StreetPoint& p, double over) {
    const Eigen::Vector2d q = beside(p, over);
    Vec3 on = toVec3(q, plan.height(q.x(), q.y()));
    on.z += kThickness;
    return on;
  };
  // At a junction the land beside this street is nearer to another one.
  const auto is_open = [&](const StreetPoint& p) {
    for (const double over : {-1.3, 1.3}) {
      const Vec3 q = on_road(p, over * StreetPlan::kRoadHalfWidth);
      if (plan.distance(q.x, q.y) < 1.15 * StreetPlan::kRoadHalfWidth) return false;
    }
    return true;
  };
  for (const StreetSection& section : plan.sections()) {
    for (std::size_t i = 0; i + 1 < section.points.size(); ++i) {
      const StreetPoint& from = section.points[i];
      const StreetPoint& to = section.points[i + 1];
      if (static_cast<int>(from.s) % kPeriod >= kDash || !is_open(from)) continue;
      addQuad(world.fixed,
              {on_road(from, -kHalfWidth), on_road(to, -kHalfWidth), on_road(to, kHalfWidth),
               on_road(from, kHalfWidth)},
              surface);
    }
  }
}

void addGuardRails(World& world, const StreetPlan& plan) {
  constexpr double kOver = StreetPlan::kRoadHalfWidth + 0.5;  // m from the centreline
  constexpr std::size_t kPostEvery = 4;                       // m
  constexpr float kLow = 0.45F;                               // m
  constexpr float kHigh = 0.75F;
  const std::uint32_t metal = world.addSurface({.tone = 0.35F});
  for (const StreetSection& section : plan.sections()) {
    for (const double over : {-kOver, kOver}) {
      const auto foot = [&](const StreetPoint& p) {
        const Eigen::Vector2d q = beside(p, over);
        return toVec3(q, plan.height(q.x(), q.y()) + StreetPlan::kKerbHeight);
      };
      const auto is_open = [&](const Vec3& at) { return plan.distance(at.x, at.y) > kOver - 0.3; };
      for (std::size_t i = 0; i + 1 < section.points.size(); ++i) {
        const Vec3 from = foot(section.points[i]);
        const Vec3 to = foot(section.points[i + 1]);
        if (!is_open(from) || !is_open(to)) continue;
        addQuad(world.fixed,
                {from + kUp * kLow, to + kUp * kLow, to + kUp * kHigh, from + kUp * kHigh}, metal);
        if (i % kPostEvery == 0) addPole(world, from, kHigh, 0.06F, metal);
      }
    }
  }
}

void addHorizon(World& world, const StreetPlan& plan, std::uint32_t seed) {
  constexpr double kAway = 130;  // m beyond the last street
  constexpr double kStep = 5;    // m
  const std::uint32_t surface =
      world.addSurface({.material = Material::Leaves, .seed = seed, .tone = 0.12F});
  const Eigen::Vector2d low = plan.lowCorner() - Eigen::Vector2d::Constant(kAway);
  const Eigen::Vector2d high = plan.highCorner() + Eigen::Vector2d::Constant(kAway);
  const auto wall = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    const int steps = 1 + static_cast<int>((to - from).norm() / kStep);
    const auto at = [&](int i, bool top) {
      const Eigen::Vector2d p = from + (to - from) * (static_cast<double>(i) / steps);
      Vec3 point = toVec3(p, plan.height(p.x(), p.y()));
      const float rise = 12 + 6 * noise2(point.x / 70, point.y / 70, seed) +
                         3 * noise2(point.x / 9, point.y / 9, seed + 1);
      point.z += top ? rise : -20;
      return point;
    };
    for (int i = 0; i < steps; ++i) {
      addQuad(world.fixed, {at(i, false), at(i + 1, false), at(i + 1, true), at(i, true)}, surface);
    }
  };
  const Eigen::Vector2d right(high.x(), low.y());
  const Eigen::Vector2d left(low.x(), high.y());
  wall(low, right);
  wall(right, high);
  wall(high, left);
  wall(left, low);
}

}  // namespace tolman::town
