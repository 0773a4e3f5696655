// SPDX-License-Identifier: BSD-3-Clause
#include "image_formation.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "noise.hpp"
#include "shutter_blur.hpp"
#include "wide_lanes.hpp"

namespace tolman::town {
namespace {

// Rain: all chosen, not tuned.
constexpr std::uint32_t kStreaks = 3000;  ///< number in front of the cameras in heavy rain
constexpr double kNearest = 0.8;          ///< m
constexpr double kFarthest = 12;          ///< m
constexpr double kFall = 8;               ///< m/s, drops of 3 mm
constexpr double kStreakWidth = 0.003;    ///< m
constexpr float kOpacity = 0.3F;          // of light that a drop replaces

/// Draws a line of the given width in px. A line thinner than a pixel covers only a part of it.
void drawLine(std::vector<float>& radiance, const RenderCamera& view, const Eigen::Vector2d& from,
              const Eigen::Vector2d& to, double width, float brightness) {
  const Eigen::Vector2d way = to - from;
  const double length = std::max(way.norm(), 1e-6);
  const double half = std::max(0.5 * width, 0.5);
  const auto opacity = static_cast<float>(std::min(1.0, width)) * kOpacity;
  const Eigen::Vector2d low = from.cwiseMin(to).array() - half;
  const Eigen::Vector2d high = from.cwiseMax(to).array() + half;
  const int last_row = std::min(static_cast<int>(std::floor(high.y())), view.height - 1);
  const int first_column = std::max(static_cast<int>(std::ceil(low.x())), 0);
  const int last_column = std::min(static_cast<int>(std::floor(high.x())), view.width - 1);
  for (int row = std::max(static_cast<int>(std::ceil(low.y())), 0); row <= last_row; ++row) {
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

/// A box filter applied twice, which is a tent filter without the hard edges of a box.
std::vector<float> halo(const std::vector<float>& light, const ImageSize& size, double radius) {
  const int pixels = std::max(1, static_cast<int>(std::lround(radius)));
  return boxBlur(boxBlur(light, size.width, size.height, pixels), size.width, size.height, pixels);
}

/// About a standard normal number: a sum of four uniform 16-bit numbers (excess kurtosis -0.3).
float normal(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t sum = (a & 0xffffU) + (a >> 16U) + (b & 0xffffU) + (b >> 16U);
  constexpr float kScale = 1.7320508F / 65536.0F;  // sqrt(3): four uniforms have variance 1/3
  return (static_cast<float>(sum) - 2 * 65535.0F) * kScale;
}

/// Constants of an exposure, in the units of its grey levels.
struct Response {
  float gain;
  float read;  ///< variance
  float shot;  ///< variance per grey level
  float fall;  ///< loss of light per squared px from the middle of the image
  std::uint32_t stream;
};

/// A plain loop, which is vectorised. `first` is the index of the row's first pixel in the image.
TOLMAN_WIDE_LANES
void levelsOfRow(const Response& response, const float* radiance, std::uint32_t first, float dy,
                 float cx, int width, float* levels) {
  const Response r = response;
  for (int column = 0; column < width; ++column) {
    const float dx = static_cast<float>(column) - cx;
    levels[column] = r.gain * radiance[column] * (1 - r.fall * (dx * dx + dy * dy));
  }
  if (r.read <= 0 && r.shot <= 0) return;
  for (int column = 0; column < width; ++column) {
    const std::uint32_t h = hash((first + static_cast<std::uint32_t>(column)) ^ r.stream);
    const float level = levels[column];
    levels[column] =
        level + std::sqrt(r.read + r.shot * std::max(level, 0.0F)) * normal(h, hash(h + r.stream));
  }
}

}  // namespace

void addRain(std::vector<float>& radiance, const RenderCamera& view,
             const Eigen::Isometry3d& T_left_camera, const Rain& rain) {
  const Eigen::Isometry3d T_camera_left = T_left_camera.inverse();
  const auto count = static_cast<std::uint32_t>(rain.density * static_cast<float>(kStreaks));
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
             view.pinhole.fx * kStreakWidth / z, rain.brightness);
  }
}

void addBloom(std::vector<float>& radiance, const ImageSize& size, float saturation, float bloom) {
  constexpr float kMaxExcess = 100;  // in units of saturation; chosen, not tuned
  std::vector<float> excess(radiance.size());
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    excess[i] = std::clamp(radiance[i] - saturation, 0.0F, kMaxExcess * saturation);
  }
  // Radii in px at scale 1, and their equal shares: chosen, not tuned.
  const std::vector<float> narrow = halo(excess, size, 4 * size.scale);
  const std::vector<float> wide = halo(excess, size, 40 * size.scale);
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    radiance[i] += 0.5F * bloom * (narrow[i] + wide[i]);
  }
}

Exposure exposureFor(const Light& light, const std::vector<double>& ms) {
  if (ms.size() < 2 || ms[0] <= 0) return {ms.empty() ? 0 : ms[0], 1};
  const Light noon = makeLight(12, Weather::Clear, 0, 0);
  const double wanted = ms[0] * static_cast<double>(light.dimness * noon.level() / light.level());
  Exposure exposure;
  exposure.time_ms = std::min(wanted, ms[1]);
  exposure.amplification = wanted / exposure.time_ms;
  return exposure;
}

Image expose(const Sensor& sensor, const std::vector<float>& radiance, std::uint32_t exposure) {
  const float cx = 0.5F * static_cast<float>(sensor.width - 1);
  const float cy = 0.5F * static_cast<float>(sensor.height - 1);
  const Response response = {static_cast<float>(sensor.gain),
                             static_cast<float>(sensor.read_noise * sensor.read_noise),
                             static_cast<float>(sensor.shot_noise),
                             static_cast<float>(sensor.vignetting) / (cx * cx + cy * cy),
                             hash(sensor.seed, exposure, 101)};
  const auto width = static_cast<std::size_t>(sensor.width);
  return Image::create(sensor.width, sensor.height, PixelFormat::Gray8, [&](std::uint8_t* data) {
    oneapi::tbb::parallel_for(0, sensor.height, [&](int row) {
      std::vector<float> levels(width);
      const std::size_t first = static_cast<std::size_t>(row) * width;
      levelsOfRow(response, radiance.data() + first, static_cast<std::uint32_t>(first),
                  static_cast<float>(row) - cy, cx, sensor.width, levels.data());
      for (std::size_t i = 0; i < width; ++i) {
        data[first + i] = static_cast<std::uint8_t>(std::clamp(levels[i] + 0.5F, 0.0F, 255.0F));
      }
    });
  });
}

}  // namespace tolman::town
