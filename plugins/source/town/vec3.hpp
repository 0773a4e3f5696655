// SPDX-License-Identifier: BSD-3-Clause
// A vector of three floats for shading, which compiles faster than Eigen's fixed vectors.
#pragma once

#include <cmath>

namespace tolman::town {

struct Vec3 {
  float x = 0;
  float y = 0;
  float z = 0;

  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(const Vec3& a, float s) { return {a.x * s, a.y * s, a.z * s}; }
};

inline float dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float norm(const Vec3& a) { return std::sqrt(dot(a, a)); }
inline Vec3 normalised(const Vec3& a) { return a * (1 / norm(a)); }

/// std::floor is a call on baseline x86-64; this is right for |x| < 2^31.
inline float floorOf(float x) {
  const auto truncated = static_cast<float>(static_cast<int>(x));
  return truncated > x ? truncated - 1 : truncated;
}

/// Placement of an instance: rotation about Z, uniform scale, then translation.
struct Placement {
  Vec3 position;
  float cosine = 1;
  float sine = 0;
  float scale = 1;

  static Placement at(const Vec3& position, float yaw, float scale = 1) {
    return {position, std::cos(yaw), std::sin(yaw), scale};
  }
  Vec3 rotate(const Vec3& v) const {
    return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z};
  }
  Vec3 unrotate(const Vec3& v) const {
    return {cosine * v.x + sine * v.y, -sine * v.x + cosine * v.y, v.z};
  }
  Vec3 toLocal(const Vec3& town) const { return unrotate(town - position) * (1 / scale); }
};

}  // namespace tolman::town
