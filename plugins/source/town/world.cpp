// SPDX-License-Identifier: BSD-3-Clause
#include "world.hpp"

#include <map>
#include <numbers>
#include <utility>

#include "noise.hpp"

namespace tolman::town {

namespace {

/// A sphere, by subdivision of an icosahedron.
struct Sphere {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

Sphere icosahedron() {
  constexpr float kGolden = std::numbers::phi_v<float>;
  Sphere sphere;
  for (const float a : {-1.0F, 1.0F}) {
    for (const float b : {-kGolden, kGolden}) {
      sphere.points.push_back(normalised({a, b, 0}));
      sphere.points.push_back(normalised({0, a, b}));
      sphere.points.push_back(normalised({b, 0, a}));
    }
  }
  // Three points are a face if their distances are the length of an edge.
  const auto neighbours = [&](std::size_t i, std::size_t j) {
    return norm(sphere.points[i] - sphere.points[j]) < 1.1F;
  };
  for (std::uint32_t i = 0; i < 12; ++i) {
    for (std::uint32_t j = i + 1; j < 12; ++j) {
      for (std::uint32_t k = j + 1; k < 12; ++k) {
        if (!neighbours(i, j) || !neighbours(j, k) || !neighbours(i, k)) continue;
        sphere.faces.push_back({i, j, k});
      }
    }
  }
  return sphere;
}

Sphere halved(const Sphere& coarse) {
  Sphere fine;
  fine.points = coarse.points;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), fine.points.size());
    if (is_new) fine.points.push_back(normalised(fine.points[a] + fine.points[b]));
    return entry->second;
  };
  for (const auto& [a, b, c] : coarse.faces) {
    const std::uint32_t ab = middle(a, b);
    const std::uint32_t bc = middle(b, c);
    const std::uint32_t ca = middle(c, a);
    fine.faces.insert(fine.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return fine;
}

}  // namespace

void addTriangle(Mesh& mesh, const std::array<Vec3, 3>& corners, std::uint32_t surface) {
  const std::uint32_t first = mesh.addVertex(corners[0]);
  mesh.addVertex(corners[1]);
  mesh.addTriangle(first, first + 1, mesh.addVertex(corners[2]), surface);
}

void addQuad(Mesh& mesh, const std::array<Vec3, 4>& corners, std::uint32_t surface) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.addTriangle(first, first + 1, first + 2, surface);
  mesh.addTriangle(first, first + 2, first + 3, surface);
}

void addBox(Mesh& mesh, const Vec3& corner, const std::array<Vec3, 3>& edges,
            std::uint32_t surface) {
  const auto& [x, y, z] = edges;
  const Vec3 far = corner + x + y;
  addQuad(mesh, {corner, corner + x, corner + x + z, corner + z}, surface);
  addQuad(mesh, {corner + x, far, far + z, corner + x + z}, surface);
  addQuad(mesh, {far, corner + y, corner + y + z, far + z}, surface);
  addQuad(mesh, {corner + y, corner, corner + z, corner + y + z}, surface);
  addQuad(mesh, {corner + z, corner + x + z, far + z, corner + y + z}, surface);
}

void addPost(Mesh& mesh, const Post& post, std::uint32_t surface) {
  const Vec3 axis = normalised(post.head - post.foot);
  const Vec3 other = std::abs(axis.z) < 0.9F ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 a = normalised(cross(axis, other));
  const Vec3 b = cross(axis, a);
  const auto ring = [&](int side) {
    const float angle =
        2 * std::numbers::pi_v<float> * static_cast<float>(side) / static_cast<float>(post.sides);
    return a * std::cos(angle) + b * std::sin(angle);
  };
  for (int side = 0; side < post.sides; ++side) {
    const Vec3 r0 = ring(side);
    const Vec3 r1 = ring(side + 1);
    addQuad(mesh,
            {post.foot + r0 * post.foot_radius, post.foot + r1 * post.foot_radius,
             post.head + r1 * post.head_radius, post.head + r0 * post.head_radius},
            surface);
  }
}

void addLump(Mesh& mesh, const Lump& lump, std::uint32_t surface) {
  Sphere sphere = icosahedron();
  for (int i = 0; i < lump.detail; ++i) sphere = halved(sphere);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vec3& p : sphere.points) {
    const float bump = noise3(p * 2.3F, lump.seed) + 0.7F * noise3(p * 5.7F, lump.seed + 1) +
                       0.6F * noise3(p * 13, lump.seed + 2);
    const float r = 1 + lump.roughness * bump;
    mesh.addVertex(lump.centre +
                   Vec3{p.x * lump.radii.x, p.y * lump.radii.y, p.z * lump.radii.z} * r);
  }
  for (const auto& [a, b, c] : sphere.faces) {
    mesh.addTriangle(first + a, first + b, first + c, surface);
  }
}

}  // namespace tolman::town
