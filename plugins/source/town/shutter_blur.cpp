// SPDX-License-Identifier: BSD-3-Clause
#include "shutter_blur.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "image_samples.hpp"
#include "wide_lanes.hpp"

namespace tolman::town {
namespace {

constexpr double kSky = 1e4;    ///< m; as good as infinite
constexpr float kSharp = 0.1F;  ///< px; pixels with shorter paths keep their value; bounds the time
constexpr float kLongest = 200;   ///< px; bounds the time
constexpr int kMaxSamples = 17;   ///< per pixel; bounds the time
constexpr double kNearest = 0.1;  ///< m in front of the camera; keeps the projection finite

/// Motion of a pinhole camera while its shutter is open: rotation by columns, then translation.
struct ShutterMotion {
  Pinhole pinhole;
  std::array<Eigen::Vector3d, 4> columns;
};

/// Paths of the pixels of a row during the motion, px: along columns and rows, and their lengths.
struct Paths {
  std::vector<float> u;
  std::vector<float> v;
  std::vector<float> length;
};

/// A plain loop, which is vectorised: most pixels have so short a path that only this is computed.
TOLMAN_WIDE_LANES
void findPaths(const ShutterMotion& motion, int row, const float* depth, int width, float* u,
               float* v, float* length) {
  const Pinhole p = motion.pinhole;
  const auto [c0, c1, c2, c3] = motion.columns;
  const double from_v = row;
  const double ray_y = (from_v - p.cy) / p.fy;
  for (int column = 0; column < width; ++column) {
    const double z = depth[column] > 0 ? static_cast<double>(depth[column]) : kSky;
    const double from_u = column;
    const double x = z * ((from_u - p.cx) / p.fx);
    const double y = z * ray_y;
    const double moved_x = c0.x() * x + c1.x() * y + c2.x() * z + c3.x();
    const double moved_y = c0.y() * x + c1.y() * y + c2.y() * z + c3.y();
    const double moved_z = c0.z() * x + c1.z() * y + c2.z() * z + c3.z();
    const auto way_u = static_cast<float>(p.fx * moved_x / moved_z + p.cx - from_u);
    const auto way_v = static_cast<float>(p.fy * moved_y / moved_z + p.cy - from_v);
    u[column] = moved_z < kNearest ? 0.0F : way_u;
    v[column] = moved_z < kNearest ? 0.0F : way_v;
    length[column] = std::sqrt(u[column] * u[column] + v[column] * v[column]);
  }
}

/// Mean along the path of a pixel, at the middles of equal intervals of time.
float meanAlong(const ImageSamples& samples, int column, int row, float u, float v, float length) {
  if (length > kLongest) {
    u *= kLongest / length;
    v *= kLongest / length;
    length = kLongest;
  }
  const int count = std::clamp(2 + static_cast<int>(std::ceil(length)), 3, kMaxSamples);
  float sum = 0;
  for (int i = 0; i < count; ++i) {
    const float t = (static_cast<float>(i) + 0.5F) / static_cast<float>(count) - 0.5F;
    sum += samples.at(static_cast<float>(column) - t * u, static_cast<float>(row) - t * v);
  }
  return sum / static_cast<float>(count);
}

}  // namespace

std::vector<float> shutterBlur(const RenderCamera& view, const std::vector<float>& sharp,
                               const std::vector<float>& depth,
                               const Eigen::Isometry3d& T_end_begin) {
  const ImageSamples samples{sharp, view.width, view.height};
  std::vector<float> blurred(sharp.size());
  const Eigen::Matrix3d R = T_end_begin.linear();
  const ShutterMotion motion = {view.pinhole,
                                {R.col(0), R.col(1), R.col(2), T_end_begin.translation()}};
  const auto width = static_cast<std::size_t>(view.width);
  oneapi::tbb::parallel_for(0, view.height, [&](int row) {
    Paths paths = {std::vector<float>(width), std::vector<float>(width), std::vector<float>(width)};
    const std::size_t first = samples.index(0, row);
    findPaths(motion, row, depth.data() + first, view.width, paths.u.data(), paths.v.data(),
              paths.length.data());
    for (std::size_t i = 0; i < width; ++i) {
      blurred[first + i] = paths.length[i] < kSharp
                               ? sharp[first + i]
                               : meanAlong(samples, static_cast<int>(i), row, paths.u[i],
                                           paths.v[i], paths.length[i]);
    }
  });
  return blurred;
}

}  // namespace tolman::town
