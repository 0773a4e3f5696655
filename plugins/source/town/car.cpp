// SPDX-License-Identifier: BSD-3-Clause
// A car: the outline of its side view, extruded to both sides and narrower towards the roof.
#include <numbers>
#include <vector>

#include "prototypes.hpp"
#include "shapes.hpp"

namespace tolman::town {
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
  constexpr float kRadius = 0.31F;
  const float side = y > 0 ? 1.0F : -1.0F;
  const Vec3 outer = {x, y + 0.02F * side, kRadius};
  const Vec3 inner = {x, y - 0.18F * side, kRadius};
  addPost(mesh, {inner, outer, kRadius, kRadius, 14}, surface);
  addPost(mesh, {outer, outer + Vec3{0, 0.001F * side, 0}, kRadius, 0.01F, 14}, surface);
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
