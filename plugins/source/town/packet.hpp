// SPDX-License-Identifier: BSD-3-Clause
// A handful of camera rays, traced and shaded together.
#pragma once

#include <array>
#include <cstdint>

#include "light.hpp"
#include "scene.hpp"
#include "street_plan.hpp"
#include "vec3.hpp"

namespace tolman::town {

/// What the rays of a packet need to know of camera and town.
struct Surroundings {
  const Scene* scene = nullptr;
  const StreetPlan* plan = nullptr;
  const Light* light = nullptr;
  Vec3 origin;   ///< of all rays
  Vec3 pixel_x;  ///< how a ray's direction changes from one pixel to the next
  Vec3 pixel_y;
};

struct Shaded {
  float radiance = 0;
  float depth = 0;         ///< in lengths of the direction; 0 for sky
  std::uint32_t seen = 0;  ///< differs where another thing, or shadow instead of light, is seen
};

/// Bit of Shaded::seen: foliage. It is all edges, and none of them is a line that could look
/// jagged.
inline constexpr std::uint32_t kFoliage = 2;

class Packet {
 public:
  explicit Packet(const Surroundings& around) : around_(around) {}

  void add(const Vec3& direction) { directions_[static_cast<std::size_t>(count_++)] = direction; }
  bool isFull() const { return count_ == kPacket; }
  int size() const { return count_; }
  /// Traces what was added; the packet is empty afterwards.
  std::array<Shaded, kPacket> shade();

 private:
  struct Meeting;
  void trace(std::array<Meeting, kPacket>& meetings);
  void castShadows(std::array<Meeting, kPacket>& meetings) const;
  Shaded shadeOne(const Meeting& meeting, const Vec3& direction) const;
  bool isFoliage(const Meeting& meeting) const;
  std::uint32_t seenAs(const Meeting& meeting) const;

  const Surroundings& around_;
  std::array<Vec3, kPacket> directions_;
  int count_ = 0;
};

}  // namespace tolman::town
