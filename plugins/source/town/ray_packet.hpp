// SPDX-License-Identifier: BSD-3-Clause
// Traces and shades up to kRaysPerPacket camera rays together: radiance (see light.hpp) and depth
// of each ray.
#pragma once

#include <array>
#include <cstdint>

#include "lamp_light.hpp"
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
};

/// Bit of Shaded::seen for foliage. Its edges are not smoothed: it has very many, and aliasing is
/// visible only on straight edges.
inline constexpr std::uint32_t kFoliage = 2;

class RayPacket {
 public:
  explicit RayPacket(const Surroundings& around) : around_(around) {}

  void add(const Vec3& origin, const Vec3& direction) {
    origins_[static_cast<std::size_t>(count_)] = origin;
    directions_[static_cast<std::size_t>(count_++)] = direction;
  }
  bool isFull() const { return count_ == kRaysPerPacket; }
  int size() const { return count_; }
  /// Traces the added rays; the packet is empty afterwards.
  std::array<Shaded, kRaysPerPacket> shade();

 private:
  struct Meeting;
  void trace(std::array<Meeting, kRaysPerPacket>& meetings);
  void castShadows(std::array<Meeting, kRaysPerPacket>& meetings) const;
  Shaded shadeOne(const Meeting& meeting, const Vec3& direction) const;
  SurfaceHit hitOf(const Meeting& meeting, const Vec3& direction) const;
  float mirrorShare(const Meeting& meeting, const Vec3& direction) const;
  float lampLight(const Meeting& meeting) const;
  float glow(const Meeting& meeting, const SurfaceHit& hit) const;
  void mirror(const std::array<Meeting, kRaysPerPacket>& meetings,
              std::array<Shaded, kRaysPerPacket>& shaded) const;
  bool isFoliage(const Meeting& meeting) const;
  std::uint32_t seenAs(const Meeting& meeting) const;

  const Surroundings& around_;
  std::array<Vec3, kRaysPerPacket> origins_;
  std::array<Vec3, kRaysPerPacket> directions_;
  int count_ = 0;
};

}  // namespace tolman::town
