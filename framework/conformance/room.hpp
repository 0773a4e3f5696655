// SPDX-License-Identifier: BSD-3-Clause
// A textured room to look at: six walls whose pictures and depths are known exactly.
#pragma once

#include <cstdint>

#include "tolman/camera.hpp"
#include "tolman/geometry.hpp"
#include "tolman/image.hpp"

namespace tolman::conformance {

/// A camera drives a circle in it, to the left, looking ahead.
class Room {
 public:
  static constexpr double kRadius = 3;  ///< m, of the circle

  explicit Room(std::uint64_t seed) : seed_(seed) {}

  /// Where the camera is after `angle` rad of the circle, relative to its first pose.
  static Eigen::Isometry3d poseAt(double angle);

  /// What a camera sees that stands `offset` m to the right of the rig's left one.
  Image view(const Eigen::Isometry3d& T_world_camera, const CameraRig& rig, double offset,
             PixelFormat format) const;

  /// Depth along the optical axis at a pixel, m.
  static double depth(const Eigen::Isometry3d& T_world_camera, const CameraRig& rig,
                      const Eigen::Vector2d& pixel);

 private:
  struct Hit {
    int wall;               ///< 0 ... 5
    Eigen::Vector3d point;  ///< m, in the room
    double distance;        ///< in lengths of the ray
  };
  static Hit cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray);
  /// Grey level of a wall at a point.
  double paint(const Hit& hit) const;
  double noise(std::uint64_t wall, double u, double v) const;

  std::uint64_t seed_;
};

}  // namespace tolman::conformance
