// SPDX-License-Identifier: BSD-3-Clause
// Adds quads, boxes, posts and lumps to a mesh.
#pragma once

#include "world.hpp"

namespace tolman::town {

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
