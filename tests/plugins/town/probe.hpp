// SPDX-License-Identifier: BSD-3-Clause
// One ray through a scene, for measurements in tests of buildings.
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>

#include "scene.hpp"

namespace tolman::town::test {

/// m from `from` to the first surface along the unit vector `way`; infinite if there is none.
inline double distanceTo(const Scene& scene, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& way) {
  alignas(32) std::array<int, kRaysPerPacket> valid{};
  valid[0] = -1;
  RTCRayHit8 rays{};
  rays.ray.org_x[0] = static_cast<float>(from.x());
  rays.ray.org_y[0] = static_cast<float>(from.y());
  rays.ray.org_z[0] = static_cast<float>(from.z());
  rays.ray.dir_x[0] = static_cast<float>(way.x());
  rays.ray.dir_y[0] = static_cast<float>(way.y());
  rays.ray.dir_z[0] = static_cast<float>(way.z());
  rays.ray.tnear[0] = 0.01F;
  rays.ray.tfar[0] = std::numeric_limits<float>::infinity();
  rays.ray.mask[0] = ~0U;
  rays.hit.geomID[0] = RTC_INVALID_GEOMETRY_ID;
  rays.hit.instID[0][0] = RTC_INVALID_GEOMETRY_ID;
  scene.intersect(valid.data(), rays);
  return static_cast<double>(rays.ray.tfar[0]);
}

}  // namespace tolman::town::test
