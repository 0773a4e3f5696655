// SPDX-License-Identifier: BSD-3-Clause
// What a shutter that stays open sees: the mean of the image along the paths of its surfaces.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer.hpp"

namespace tolman::town {

/// Bilinear interpolation; outside of the image the value at its border.
struct ImageSamples {
  const std::vector<float>& values;
  int width;
  int height;

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
  float at(float u, float v) const {
    u = std::clamp(u, 0.0F, static_cast<float>(width - 1));
    v = std::clamp(v, 0.0F, static_cast<float>(height - 1));
    return interpolate(std::min(static_cast<int>(u), width - 2),
                       std::min(static_cast<int>(v), height - 2), u, v);
  }
  /// The same for 0 <= u < width - 1 and 0 <= v < height - 1.
  float inside(float u, float v) const {
    return interpolate(static_cast<int>(u), static_cast<int>(v), u, v);
  }

 private:
  float interpolate(int c, int r, float u, float v) const {
    const float fu = u - static_cast<float>(c);
    const float fv = v - static_cast<float>(r);
    const std::size_t i = index(c, r);
    const std::size_t below = i + static_cast<std::size_t>(width);
    return (1 - fv) * ((1 - fu) * values[i] + fu * values[i + 1]) +
           fv * ((1 - fu) * values[below] + fu * values[below + 1]);
  }
};

/// Mean over a box of 2 * radius + 1 px, along rows and then along columns; at the border over the
/// part inside of the image.
std::vector<float> boxBlur(const std::vector<float>& values, int width, int height, int radius);

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

/// Mean radiance while the shutter is open; `sharp` is the picture of `view`, in the middle of this
/// time.
std::vector<float> shutterBlur(const RenderCamera& view, const RenderedImage& sharp,
                               const OpenShutter& shutter);

}  // namespace tolman::town
