// SPDX-License-Identifier: BSD-3-Clause
// Shapes: closed where they should be, of the right size.
#include "shapes.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <utility>

using namespace tolman::town;

namespace {

Vec3 vertex(const Mesh& mesh, std::uint32_t i) {
  return {mesh.vertices[i].x, mesh.vertices[i].y, mesh.vertices[i].z};
}

float area(const Mesh& mesh) {
  float sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += 0.5F * norm(cross(vertex(mesh, b) - vertex(mesh, a), vertex(mesh, c) - vertex(mesh, a)));
  }
  return sum;
}

}  // namespace

TEST_CASE("a smooth lump is a closed sphere with 20 * 4^detail triangles") {
  Mesh mesh;
  addLump(mesh, {{1, 2, 3}, {2, 2, 2}, 0, 3, 0}, 9);
  CHECK(mesh.triangles.size() == 20 * 64);
  CHECK(mesh.surfaces.size() == mesh.triangles.size());
  CHECK(area(mesh) == Approx(4 * 3.14159F * 4).epsilon(0.01));
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(triangle[i], triangle[(i + 1) % 3])];
  }
  for (const auto& [edge, uses] : edges) REQUIRE(uses == 2);
  for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
    REQUIRE(norm(vertex(mesh, i) - Vec3{1, 2, 3}) == Approx(2).margin(1e-4));
  }
}

TEST_CASE("a box has five faces, a post its mantle") {
  Mesh box;
  addBox(box, {0, 0, 0}, {Vec3{2, 0, 0}, Vec3{0, 3, 0}, Vec3{0, 0, 4}}, 1);
  CHECK(area(box) == Approx(2 * (2 * 4 + 3 * 4) + 2 * 3));
  Mesh post;
  addPost(post, {{0, 0, 0}, {0, 0, 5}, 0.5F, 0.5F, 64}, 1);
  CHECK(area(post) == Approx(2 * 3.14159F * 0.5F * 5).epsilon(0.01));
}
