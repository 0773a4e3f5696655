// SPDX-License-Identifier: BSD-3-Clause
// Light of street lamps and of the car's own headlights at night. Neither casts shadows.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "light.hpp"
#include "vec3.hpp"

namespace tolman::town {

class StreetLamps {
 public:
  StreetLamps() = default;
  explicit StreetLamps(const std::vector<Vec3>& heads);

  /// Irradiance / pi at a point with unit normal `n`.
  float onto(const Vec3& point, const Vec3& n) const;
  /// Whether the point is on the head of a lamp, which emits light.
  bool isHead(const Vec3& point) const;

 private:
  const std::vector<std::uint32_t>* near(const Vec3& point) const;

  std::vector<Vec3> heads_;
  std::unordered_map<std::int64_t, std::vector<std::uint32_t>> cells_;
};

/// Radiance of the lamps of a car at a point of its bodywork, in axes of the car.
float carLamps(const Vec3& point, const Vec3& normal);

/// Low beams: bright below the horizon straight ahead.
float headlightsOnto(const Headlights& beams, const Vec3& point, const Vec3& n);

}  // namespace tolman::town
