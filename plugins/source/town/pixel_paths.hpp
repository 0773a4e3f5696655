// SPDX-License-Identifier: BSD-3-Clause
// How far the surface of each pixel moves across the image while the shutter is open.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "renderer.hpp"

namespace tolman::town {

/// Motion of a camera, or of an object, while the shutter is open: takes coordinates in the middle
/// of this time to those at its beginning and end.
struct ShutterMotion {
  Eigen::Isometry3d T_begin_middle = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_end_middle = Eigen::Isometry3d::Identity();
};

/// Everything that moves while the shutter is open.
struct OpenShutter {
  ShutterMotion camera;  ///< of fixed points, in the axes of the camera
  /// Of the instances first_object, first_object + 1, and so on, in the town's axes. All others
  /// are fixed.
  std::vector<ShutterMotion> objects;
  std::uint32_t first_object = 0;
};

/// Displacement from one place in the image to another, px.
struct Path {
  float u = 0;
  float v = 0;

  friend Path operator-(const Path& a, const Path& b) { return {a.u - b.u, a.v - b.v}; }
  float square() const { return u * u + v * v; }
};

/// For each pixel, the displacement of its surface from the beginning to the end of the time that
/// the shutter is open; row-major.
struct PixelPaths {
  Path at(std::size_t i) const { return {u[i], v[i]}; }

  std::vector<float> u;
  std::vector<float> v;
  std::vector<float> z;  ///< m along the optical axis; a large number for the sky
};

/// `picture` was rendered from `view` in the middle of the time that the shutter is open. Paths are
/// 0 where the surface passes behind the camera, and at most kLongestPath long.
PixelPaths pixelPaths(const RenderCamera& view, const RenderedImage& picture,
                      const OpenShutter& shutter);

inline constexpr float kLongestPath = 200;  ///< px; bounds the computing time

}  // namespace tolman::town
