// SPDX-License-Identifier: BSD-3-Clause
#include "sensor.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "noise.hpp"
#include "wide_lanes.hpp"

namespace tolman::town {
namespace {

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

Image expose(const Sensor& sensor, const std::vector<float>& radiance, std::uint32_t exposure) {
  const float cx = 0.5F * static_cast<float>(sensor.width - 1);
  const float cy = 0.5F * static_cast<float>(sensor.height - 1);
  const Response response = {static_cast<float>(sensor.gain),
                             static_cast<float>(sensor.read_noise * sensor.read_noise),
                             static_cast<float>(sensor.shot_noise),
                             static_cast<float>(sensor.vignetting) / (cx * cx + cy * cy),
                             hash(sensor.seed, exposure, 101)};
  const auto gamma = static_cast<float>(sensor.gamma);
  const auto width = static_cast<std::size_t>(sensor.width);
  const auto exposeRow = [&](int row, std::uint8_t* out) {
    std::vector<float> levels(width);
    const std::size_t first = static_cast<std::size_t>(row) * width;
    levelsOfRow(response, radiance.data() + first, static_cast<std::uint32_t>(first),
                static_cast<float>(row) - cy, cx, sensor.width, levels.data());
    for (std::size_t i = 0; gamma != 1 && i < width; ++i) {
      levels[i] = 255 * std::pow(std::clamp(levels[i] / 255, 0.0F, 1.0F), gamma);
    }
    for (std::size_t i = 0; i < width; ++i) {
      out[i] = static_cast<std::uint8_t>(std::clamp(levels[i] + 0.5F, 0.0F, 255.0F));
    }
  };
  return Image::create(sensor.width, sensor.height, PixelFormat::Gray8, [&](std::uint8_t* data) {
    oneapi::tbb::parallel_for(0, sensor.height, [&](int row) {
      exposeRow(row, data + std::ptrdiff_t{row} * sensor.width);
    });
  });
}

}  // namespace tolman::town
