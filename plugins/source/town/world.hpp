// SPDX-License-Identifier: BSD-3-Clause
// The geometry of the town: fixed triangles, and prototypes that are placed many times.
//
// Town frame: X right and Y forward of the first camera, Z up, metres; the origin is the first
// camera. A camera vector (x, y, z) is (x, z, -y) in axes of the town.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shadow_grid.hpp"
#include "street_plan.hpp"
#include "vec3.hpp"

namespace tolman::town {

inline constexpr float kStorey = 2.9F;  ///< m, of houses

inline Vec3 toVec3(const Eigen::Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}
inline Vec3 toVec3(const Eigen::Vector2d& v, double z) { return toVec3({v.x(), v.y(), z}); }

struct Mesh {
  using Vertex = Vec3;
  using Triangle = std::array<std::uint32_t, 3>;  ///< counter-clockwise seen from outside

  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> surfaces;  ///< of each triangle: index into the table of surfaces

  std::uint32_t addVertex(const Vertex& vertex) {
    vertices.push_back(vertex);
    return static_cast<std::uint32_t>(vertices.size() - 1);
  }
  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t surface) {
    triangles.push_back({a, b, c});
    surfaces.push_back(surface);
  }
  std::array<Vec3, 3> corners(std::size_t triangle) const {
    const auto& [a, b, c] = triangles[triangle];
    return {vertices[a], vertices[b], vertices[c]};
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
  Vec3 origin = {};
  Vec3 axis_u = {1, 0, 0};
  Vec3 axis_v = {0, 0, 1};
  float width = 0;   ///< m along u, for patterns that depend on their end
  float height = 0;  ///< m along v
};

/// A rectangle on the ground.
struct Plot {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();  ///< unit vector of its length
  double half_length = 1;                           ///< m, along axis
  double half_depth = 1;                            ///< m, across

  Eigen::Vector2d across() const { return {-axis.y(), axis.x()}; }
  Eigen::Vector2d point(double along, double over) const {
    return centre + axis * along + across() * over;
  }
};

struct MeshInstance {
  std::uint32_t prototype = 0;
  Placement placement;
  std::uint32_t seed = 0;  ///< of texture and tone
};

struct World {
  std::vector<Surface> surfaces;
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
  std::uint32_t addPrototype(Mesh mesh) {
    prototypes.push_back(std::move(mesh));
    return static_cast<std::uint32_t>(prototypes.size() - 1);
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

// Adds quads, boxes, posts and lumps to a mesh.

/// `corners` in their order around the quad.
void addQuad(Mesh& mesh, const std::array<Vec3, 4>& corners, std::uint32_t surface);
void addTriangle(Mesh& mesh, const std::array<Vec3, 3>& corners, std::uint32_t surface);

/// A box that spans three edges from its corner; sides and top, no bottom.
void addBox(Mesh& mesh, const Vec3& corner, const std::array<Vec3, 3>& edges,
            std::uint32_t surface);

/// A tapered post between two points, `sides` faces, open at the ends.
struct Post {
  Vec3 foot;
  Vec3 head;
  float foot_radius = 0.1F;
  float head_radius = 0.1F;
  int sides = 8;
};
void addPost(Mesh& mesh, const Post& post, std::uint32_t surface);

/// An ellipsoid with bumps: an icosahedron after `detail` subdivisions (20 * 4^detail triangles).
struct Lump {
  Vec3 centre;
  Vec3 radii = {1, 1, 1};
  float roughness = 0.2F;  ///< relative height of the bumps
  int detail = 2;
  std::uint32_t seed = 0;
};
void addLump(Mesh& mesh, const Lump& lump, std::uint32_t surface);

}  // namespace tolman::town
