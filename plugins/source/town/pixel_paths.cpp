// SPDX-License-Identifier: BSD-3-Clause
#include "pixel_paths.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <array>
#include <cmath>

#include "wide_lanes.hpp"

namespace tolman::town {
namespace {

constexpr float kSkyDepth = 1e4F;      ///< m; stands for infinity
constexpr float kNearestDepth = 0.1F;  ///< m in front of the camera; keeps the projection finite

/// A pinhole camera in the middle, at the beginning and at the end of the shutter time.
struct Projections {
  explicit Projections(const Pinhole& pinhole, const ShutterMotion& motion)
      : fx(static_cast<float>(pinhole.fx)),
        fy(static_cast<float>(pinhole.fy)),
        cx(static_cast<float>(pinhole.cx)),
        cy(static_cast<float>(pinhole.cy)),
        begin(rowsOf(motion.T_begin_middle)),
        end(rowsOf(motion.T_end_middle)) {}

  using Rows = std::array<std::array<float, 4>, 3>;
  static Rows rowsOf(const Eigen::Isometry3d& T) {
    Rows rows;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 4; ++c) {
        rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] =
            static_cast<float>(T.matrix()(r, c));
      }
    }
    return rows;
  }

  float fx, fy, cx, cy;
  Rows begin, end;
};

/// A part of a row of the image.
struct PartOfRow {
  int row;
  int first;
  int count;
};

/// A plain loop, so that the compiler vectorises it.
TOLMAN_WIDE_LANES
void findPaths(const Projections& p, const PartOfRow& part, float* z, float* u, float* v) {
  const auto [b0, b1, b2] = p.begin;
  const auto [e0, e1, e2] = p.end;
  const float ray_y = (static_cast<float>(part.row) - p.cy) / p.fy;
  for (int i = 0; i < part.count; ++i) {
    const float depth = z[i] > 0 ? z[i] : kSkyDepth;
    const float x = depth * ((static_cast<float>(part.first + i) - p.cx) / p.fx);
    const float y = depth * ray_y;
    const float begin_z = b2[0] * x + b2[1] * y + b2[2] * depth + b2[3];
    const float end_z = e2[0] * x + e2[1] * y + e2[2] * depth + e2[3];
    const float to_begin = 1 / begin_z;
    const float to_end = 1 / end_z;
    const float way_u = p.fx * ((e0[0] * x + e0[1] * y + e0[2] * depth + e0[3]) * to_end -
                                (b0[0] * x + b0[1] * y + b0[2] * depth + b0[3]) * to_begin);
    const float way_v = p.fy * ((e1[0] * x + e1[1] * y + e1[2] * depth + e1[3]) * to_end -
                                (b1[0] * x + b1[1] * y + b1[2] * depth + b1[3]) * to_begin);
    const bool is_behind = begin_z < kNearestDepth || end_z < kNearestDepth;
    const float length = std::sqrt(way_u * way_u + way_v * way_v);
    const float kept = is_behind ? 0.0F : length > kLongestPath ? kLongestPath / length : 1.0F;
    z[i] = depth;
    u[i] = is_behind ? 0.0F : kept * way_u;
    v[i] = is_behind ? 0.0F : kept * way_v;
  }
}

/// Motion of a point of the object in the axes of the camera.
ShutterMotion seenBy(const Eigen::Isometry3d& T_town_camera, const ShutterMotion& camera,
                     const ShutterMotion& object) {
  const Eigen::Isometry3d T_camera_town = T_town_camera.inverse();
  return {camera.T_begin_middle * T_camera_town * object.T_begin_middle * T_town_camera,
          camera.T_end_middle * T_camera_town * object.T_end_middle * T_town_camera};
}

}  // namespace

PixelPaths pixelPaths(const RenderCamera& view, const RenderedImage& picture,
                      const OpenShutter& shutter) {
  const std::size_t pixels = picture.depth.size();
  PixelPaths paths = {std::vector<float>(pixels), std::vector<float>(pixels), picture.depth};
  const Projections fixed(view.pinhole, shutter.camera);
  std::vector<Projections> moving;
  for (const ShutterMotion& object : shutter.objects) {
    moving.emplace_back(view.pinhole, seenBy(view.T_town_camera, shutter.camera, object));
  }
  oneapi::tbb::parallel_for(0, view.height, [&](int row) {
    const auto width = static_cast<std::size_t>(view.width);
    const std::size_t at = static_cast<std::size_t>(row) * width;
    findPaths(fixed, {row, 0, view.width}, &paths.z[at], &paths.u[at], &paths.v[at]);
    for (std::size_t i = 0; i < width && !moving.empty(); ++i) {
      // Wraps around to a large number for instances before the first object.
      const std::uint32_t object = picture.instance[at + i] - shutter.first_object;
      if (object >= moving.size()) continue;
      findPaths(moving[object], {row, static_cast<int>(i), 1}, &paths.z[at + i], &paths.u[at + i],
                &paths.v[at + i]);
    }
  });
  return paths;
}

}  // namespace tolman::town
