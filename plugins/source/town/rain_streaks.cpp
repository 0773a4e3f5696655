// SPDX-License-Identifier: BSD-3-Clause
#include "rain_streaks.hpp"

#include <algorithm>
#include <cmath>

#include "noise.hpp"

namespace tolman::town {
namespace {

// All chosen, not tuned.
constexpr std::uint32_t kDrops = 3000;  ///< number in front of the cameras in heavy rain
constexpr double kNearest = 0.8;        ///< m
constexpr double kFarthest = 12;        ///< m
constexpr double kFall = 8;             ///< m/s, drops of 3 mm
constexpr double kWidth = 0.003;        ///< m
constexpr float kOpacity = 0.3F;        // of light that a drop replaces

/// Draws a line of the given width in px. A line thinner than a pixel covers only a part of it.
void drawLine(std::vector<float>& radiance, const RenderCamera& view, const Eigen::Vector2d& from,
              const Eigen::Vector2d& to, double width, float brightness) {
  const Eigen::Vector2d way = to - from;
  const double length = std::max(way.norm(), 1e-6);
  const double half = std::max(0.5 * width, 0.5);
  const auto opacity = static_cast<float>(std::min(1.0, width)) * kOpacity;
  const Eigen::Vector2d low = from.cwiseMin(to).array() - half;
  const Eigen::Vector2d high = from.cwiseMax(to).array() + half;
  const int first_row = std::max(static_cast<int>(std::ceil(low.y())), 0);
  const int last_row = std::min(static_cast<int>(std::floor(high.y())), view.height - 1);
  const int first_column = std::max(static_cast<int>(std::ceil(low.x())), 0);
  const int last_column = std::min(static_cast<int>(std::floor(high.x())), view.width - 1);
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      const Eigen::Vector2d at = Eigen::Vector2d(column, row) - from;
      const double along = at.dot(way) / length;
      const double across = std::abs(at.x() * way.y() - at.y() * way.x()) / length;
      if (along < -half || along > length + half || across > half) continue;
      const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(view.width) +
                     static_cast<std::size_t>(column);
      radiance[i] += opacity * (brightness - radiance[i]);
    }
  }
}

}  // namespace

void addRain(std::vector<float>& radiance, const RenderCamera& view,
             const Eigen::Isometry3d& T_left_camera, const Rain& rain) {
  const Eigen::Isometry3d T_camera_left = T_left_camera.inverse();
  const auto count = static_cast<std::uint32_t>(rain.density * static_cast<float>(kDrops));
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t own = hash(rain.seed, i, 601);
    const auto random = [&](std::uint32_t number) {
      return static_cast<double>(unit(hash(own, number)));
    };
    // Their density over depth is proportional to the width of the view.
    const double z = kNearest + (kFarthest - kNearest) * std::sqrt(random(1));
    const Eigen::Vector3d begin(z * (2 * random(2) - 1), z * 0.4 * (2 * random(3) - 1), z);
    const Eigen::Vector3d moved(0, kFall * rain.exposure_s, -rain.speed_m_s * rain.exposure_s);
    const Eigen::Vector3d a = T_camera_left * begin;
    const Eigen::Vector3d b = T_camera_left * (begin + moved);
    if (std::min(a.z(), b.z()) < 0.3) continue;
    drawLine(radiance, view, view.pinhole.project(a), view.pinhole.project(b),
             view.pinhole.fx * kWidth / z, rain.brightness);
  }
}

}  // namespace tolman::town
