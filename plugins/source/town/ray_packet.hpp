// SPDX-License-Identifier: BSD-3-Clause
// Traces and shades up to kRaysPerPacket camera rays together: radiance (see light.hpp) and depth
// of each ray.
#pragma once

#include <array>
#include <cstdint>
#include <tuple>

#include "light.hpp"
#include "material.hpp"
#include "scene.hpp"
#include "street_plan.hpp"
#include "vec3.hpp"

namespace tolman::town {

/// Scene, light and pixel size that the rays of a packet share.
struct Surroundings {
  const Scene* scene = nullptr;
  const StreetPlan* plan = nullptr;
  const Light* light = nullptr;
  const StreetLamps* lamps = nullptr;  ///< null without lamps
  Vec3 pixel_x;                        ///< change of a ray's direction from one pixel to the next
  Vec3 pixel_y;
};

struct Shaded {
  float radiance = 0;
  float depth = 0;         ///< in units of the length of the direction; 0 for sky
  std::uint32_t seen = 0;  ///< key that differs between objects, and between light and shadow
  std::uint32_t instance = kNoInstance;
};

/// Bit of Shaded::seen for foliage. Its edges are not smoothed: it has very many, and aliasing is
/// visible only on straight edges.
inline constexpr std::uint32_t kFoliage = 2;

class RayPacket {
 public:
  explicit RayPacket(const Surroundings& around) : around_(around) {}

  void add(const Vec3& origin, const Vec3& direction) { set(count_++, origin, direction); }
  bool isFull() const { return count_ == kRaysPerPacket; }
  int size() const { return count_; }
  /// Traces the added rays; the packet is empty afterwards.
  std::array<Shaded, kRaysPerPacket> shade();

 private:
  static constexpr std::size_t kGroups = kRaysPerPacket / kLanes;
  struct Meetings;

  void set(int i, const Vec3& origin, const Vec3& direction) {
    RTCRay16& r = rays_.ray;
    std::tie(r.org_x[i], r.org_y[i], r.org_z[i]) = std::tie(origin.x, origin.y, origin.z);
    std::tie(r.dir_x[i], r.dir_y[i], r.dir_z[i]) = std::tie(direction.x, direction.y, direction.z);
  }
  void meet(std::size_t group, Meetings& meetings) const;
  void castShadows(Meetings& meetings) const;
  void shadeGroup(const Meetings& meetings, Shaded* shaded) const;
  void addLamps(const Meetings& meetings, const SurfaceHits& hits, const Eight& tone,
                Eight& radiance) const;
  void weather(const Meetings& meetings, const SurfaceHits& hits, Eight& tone) const;
  SurfaceHits hitsOf(const Meetings& meetings) const;
  template <class Body>
  void forEachSurface(const Meetings& meetings, const Body& body) const;

  const Surroundings& around_;
  RTCRayHit16 rays_;
  int count_ = 0;
};

}  // namespace tolman::town
