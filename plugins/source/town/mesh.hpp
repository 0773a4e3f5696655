// SPDX-License-Identifier: BSD-3-Clause
// Triangles of the town, the input of the ray tracer.
//
// Town frame: X right and Y forward of the first camera, Z up, metres; the origin is the first
// camera. A camera vector (x, y, z) is (x, z, -y) in axes of the town.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tolman::town {

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

}  // namespace tolman::town
