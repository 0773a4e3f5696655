// SPDX-License-Identifier: BSD-3-Clause
#include "shutter_blur.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "image_samples.hpp"

namespace tolman::town {
namespace {

constexpr double kSky = 1e4;    ///< m; as good as infinite
constexpr float kSharp = 0.1F;  ///< px; pixels with shorter paths keep their value; bounds the time
constexpr float kLongest = 200;   ///< px; bounds the time
constexpr int kMaxSamples = 17;   ///< per pixel; bounds the time
constexpr double kNearest = 0.1;  ///< m in front of the camera; keeps the projection finite

}  // namespace

std::vector<float> shutterBlur(const RenderCamera& view, const std::vector<float>& sharp,
                               const std::vector<float>& depth,
                               const Eigen::Isometry3d& T_end_begin) {
  const ImageSamples samples{sharp, view.width, view.height};
  std::vector<float> blurred(sharp.size());
  const Pinhole& pinhole = view.pinhole;
  const auto path = [&](int column, int row, float z_depth) -> Eigen::Vector2f {
    const double z = z_depth > 0 ? static_cast<double>(z_depth) : kSky;
    const Eigen::Vector2d from(column, row);
    const Eigen::Vector3d moved = T_end_begin * (z * pinhole.ray(from));
    if (moved.z() < kNearest) return Eigen::Vector2f::Zero();
    return (pinhole.project(moved) - from).cast<float>();
  };
  oneapi::tbb::parallel_for(0, view.height, [&](int row) {
    for (int column = 0; column < view.width; ++column) {
      const std::size_t at = samples.index(column, row);
      Eigen::Vector2f way = path(column, row, depth[at]);
      float length = way.norm();
      if (length > kLongest) {
        way *= kLongest / length;
        length = kLongest;
      }
      if (length < kSharp) {
        blurred[at] = sharp[at];
        continue;
      }
      const int count = std::clamp(2 + static_cast<int>(std::ceil(length)), 3, kMaxSamples);
      float sum = 0;
      for (int i = 0; i < count; ++i) {  // at the middles of equal intervals of time
        const float t = (static_cast<float>(i) + 0.5F) / static_cast<float>(count) - 0.5F;
        sum += samples.at(static_cast<float>(column) - t * way.x(),
                          static_cast<float>(row) - t * way.y());
      }
      blurred[at] = sum / static_cast<float>(count);
    }
  });
  return blurred;
}

}  // namespace tolman::town
