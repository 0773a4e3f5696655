// SPDX-License-Identifier: BSD-3-Clause
// A map of where something may stand between a point and the sun, so that rays to the sun are
// traced only there. It looks along the light: points on one ray to the sun are in one cell.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lanes.hpp"
#include "vec3.hpp"

namespace tolman::town {

/// Rectangle of the town's X and Y, m.
struct GroundArea {
  Vec3 low;
  Vec3 high;
};

class ShadowGrid {
 public:
  /// What may cast a shadow in a cell; bits.
  enum Casters : std::uint8_t { kFixed = 1, kPlaced = 2, kMoving = 4, kAll = 7 };

  /// Clears the map and makes it one for light from `to_sun`, over `area` at Z = 0. With a sun near
  /// the horizon, whose shadows are everywhere, it stays off.
  void start(const Vec3& to_sun, const GroundArea& area);
  void stop() { cells_.clear(); }
  bool isOn() const { return !cells_.empty(); }

  /// Marks the cells that a triangle covers, and a few more.
  void mark(const std::array<Vec3, 3>& corners);
  /// The same for a box, whose corner i has the bit 0 of i along its first axis, bit 1 along its
  /// second, and bit 2 along its third one. Moving boxes are forgotten by forgetMoving().
  void mark(const std::array<Vec3, 8>& corners, bool is_moving);
  void forgetMoving();

  /// Whether fixed geometry, and instances, may shade the points: always where the map is off or
  /// does not reach.
  TOLMAN_INLINE void look(const Vec3s& points, EightInts& fixed, EightInts& placed) const;

 private:
  struct Flat {
    float u;
    float v;
  };
  struct Run {
    std::size_t first;
    std::size_t count;
  };
  Flat alongLight(const Vec3& p) const;
  void markHull(std::span<const Flat> points, std::span<const std::array<std::uint8_t, 2>> edges,
                std::uint8_t caster);
  void markRun(int row, float low, float high, std::uint8_t caster);

  float along_x_ = 0;  ///< m along X that the light covers while it falls by 1 m
  float along_y_ = 0;
  float low_x_ = 0;
  float low_y_ = 0;
  float per_m_ = 0;  ///< cells
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::uint8_t> cells_;
  std::vector<Run> moving_;
};

TOLMAN_INLINE void ShadowGrid::look(const Vec3s& points, EightInts& fixed,
                                    EightInts& placed) const {
  fixed = placed = ~EightInts{};
  if (!isOn()) return;
  const Eight u = (points.x - along_x_ * points.z - low_x_) * per_m_;
  const Eight v = (points.y - along_y_ * points.z - low_y_) * per_m_;
  const EightInts inside =
      (u >= 0) & (v >= 0) & (u < static_cast<float>(columns_)) & (v < static_cast<float>(rows_));
  const EightInts at = (truncated(v) * columns_ + truncated(u)) & inside;
  std::array<std::int32_t, kLanes> casters;
  for (int i = 0; i < kLanes; ++i) {
    casters[static_cast<std::size_t>(i)] = cells_[static_cast<std::size_t>(at[i])];
  }
  EightInts bits;
  std::memcpy(&bits, casters.data(), sizeof bits);
  fixed = ~inside | ((bits & int{kFixed}) != 0);
  placed = ~inside | ((bits & int{kPlaced | kMoving}) != 0);
}

}  // namespace tolman::town
