// SPDX-License-Identifier: BSD-3-Clause
// Appearance of a triangle: material, tone, and the coordinates of its texture pattern.
#pragma once

#include <cstdint>
#include <vector>

#include "vec3.hpp"

namespace tolman::town {

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
  Cloth,   ///< clothes, with a tone for each person
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

}  // namespace tolman::town
