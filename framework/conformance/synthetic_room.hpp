// SPDX-License-Identifier: BSD-3-Clause
// A box-shaped room with six textured walls. Images and depths are computed by intersecting the ray
// of each pixel with the walls, so they are exact.
#pragma once

#include <cstdint>

#include "tolman/camera.hpp"
#include "tolman/geometry.hpp"
#include "tolman/image.hpp"

namespace tolman::conformance {

/// The camera moves on a circle to the left and looks along the tangent.
class SyntheticRoom {
 public:
  static constexpr double kRadius = 3;  ///< m, of the circle

  explicit SyntheticRoom(std::uint64_t seed) : seed_(seed) {}

  /// Pose after `angle` rad of the circle, relative to the first pose.
  static Eigen::Isometry3d poseAt(double angle);

  /// Image of a camera `offset` m to the right of the rig's left camera.
  Image view(const Eigen::Isometry3d& T_world_camera, const CameraRig& rig, double offset,
             PixelFormat format) const;

  /// Depth along the optical axis at a pixel, m.
  static double depth(const Eigen::Isometry3d& T_world_camera, const CameraRig& rig,
                      const Eigen::Vector2d& pixel);

 private:
  struct Hit {
    int wall;               ///< 0 ... 5
    Eigen::Vector3d point;  ///< m, in the room
    double distance;        ///< in units of the length of the ray
  };
  static Hit castRay(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray);
  /// Grey level of a wall at a point.
  double greyLevel(const Hit& hit) const;
  double noise(std::uint64_t wall, double u, double v) const;

  std::uint64_t seed_;
};

}  // namespace tolman::conformance
