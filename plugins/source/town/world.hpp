// SPDX-License-Identifier: BSD-3-Clause
// The geometry of the town: fixed triangles, and prototypes that are placed many times.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh.hpp"
#include "plots.hpp"
#include "shadow_grid.hpp"
#include "street_plan.hpp"
#include "surface.hpp"

namespace tolman::town {

struct MeshInstance {
  std::uint32_t prototype = 0;
  Placement placement;
  std::uint32_t seed = 0;  ///< of texture and tone
  bool shines = false;     ///< a car with its lamps on at night
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
