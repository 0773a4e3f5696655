// SPDX-License-Identifier: BSD-3-Clause
// The geometry of the town: fixed triangles, and prototypes that are placed many times.
//
// Town frame: X right and Y forward of the first camera, Z up, metres; the origin is the first
// camera. A camera vector (x, y, z) is (x, z, -y) in axes of the town.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plots.hpp"
#include "shadow_grid.hpp"
#include "street_plan.hpp"
#include "vec3.hpp"

namespace tolman::town {

inline Vec3 toVec3(const Eigen::Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

inline constexpr float kStorey = 2.9F;  ///< m, of houses

struct Mesh {
  struct Vertex {
    float x = 0;
    float y = 0;
    float z = 0;
  };
  using Triangle = std::array<std::uint32_t, 3>;  ///< counter-clockwise seen from outside

  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> surfaces;  ///< of each triangle: index into the table of surfaces

  std::uint32_t addVertex(float x, float y, float z) {
    vertices.push_back({x, y, z});
    return static_cast<std::uint32_t>(vertices.size() - 1);
  }
  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t surface) {
    triangles.push_back({a, b, c});
    surfaces.push_back(surface);
  }
};

enum class Material : std::uint8_t {
  Road,    ///< asphalt
  Kerb,    ///< concrete stones
  Land,    ///< pavement, verge, grass, by distance to the street
  Paint,   ///< lane markings
  Facade,  ///< plaster or brick with windows and doors
  Roof,    ///< tiles
  Plain,   ///< a smooth wall, post or panel with little texture
  Wood,    ///< boards of fences
  Leaves,  ///< crowns and hedges
  Bark,    ///< trunks
  Body,    ///< bodywork of cars, with windows by height
  Board,   ///< signs and posters
};

struct Surface {
  Material material = Material::Plain;
  std::uint32_t seed = 0;
  float tone = 0.5F;  ///< mean albedo
  /// Pattern coordinates of a point p: u = (p - origin) . axis_u, v alike, in metres. Town axes, or
  /// those of the prototype for instances.
  Vec3 origin;
  Vec3 axis_u = {1, 0, 0};
  Vec3 axis_v = {0, 0, 1};
  float width = 0;   ///< m along u, for patterns that depend on their end
  float height = 0;  ///< m along v
};

using SurfaceTable = std::vector<Surface>;

struct MeshInstance {
  std::uint32_t prototype = 0;
  Placement placement;
  std::uint32_t seed = 0;  ///< of texture and tone
};

struct World {
  SurfaceTable surfaces;
  Mesh fixed;                        ///< town axes; the ground is first
  std::size_t ground_triangles = 0;  ///< of the fixed mesh: a surface with one height at each place
  GroundArea area;                   ///< that streets, houses and trees cover
  std::vector<Mesh> prototypes;      ///< own axes: Z up, standing on the origin
  std::vector<MeshInstance> instances;
  std::vector<std::uint32_t> cars;        ///< the prototypes that are cars
  std::vector<std::uint32_t> evergreens;  ///< the prototypes that have leaves in winter
  std::vector<Vec3> lamp_heads;           ///< middles, town axes

  std::uint32_t addSurface(const Surface& surface) {
    surfaces.push_back(surface);
    return static_cast<std::uint32_t>(surfaces.size() - 1);
  }
};

struct WorldOptions {
  std::uint32_t seed = 1;
  double aliasing = 0.15;  ///< share of stretches that look like others
  double density = 1;      ///< of houses, trees and parked cars; 0 leaves bare streets
  bool guard_rails = false;
  std::vector<Plot> reserved;  ///< ground of other objects
};

World buildWorld(const StreetPlan& plan, const WorldOptions& options);

}  // namespace tolman::town
