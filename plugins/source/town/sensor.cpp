// SPDX-License-Identifier: BSD-3-Clause
#include "sensor.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "noise.hpp"

namespace tolman::town {
namespace {

/// About a standard normal number: a sum of four uniform 16-bit numbers (excess kurtosis -0.3).
float normal(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t sum = (a & 0xffffU) + (a >> 16U) + (b & 0xffffU) + (b >> 16U);
  constexpr float kScale = 1.7320508F / 65536.0F;  // sqrt(3): four uniforms have variance 1/3
  return (static_cast<float>(sum) - 2 * 65535.0F) * kScale;
}

}  // namespace

Image expose(const Sensor& sensor, const std::vector<float>& radiance, std::uint32_t exposure) {
  const auto gain = static_cast<float>(sensor.gain);
  const auto read = static_cast<float>(sensor.read_noise * sensor.read_noise);
  const auto shot = static_cast<float>(sensor.shot_noise);
  const bool noisy = read > 0 || shot > 0;
  const float cx = 0.5F * static_cast<float>(sensor.width - 1);
  const float cy = 0.5F * static_cast<float>(sensor.height - 1);
  const float fall = static_cast<float>(sensor.vignetting) / (cx * cx + cy * cy);
  const auto gamma = static_cast<float>(sensor.gamma);
  const std::uint32_t stream = hash(sensor.seed, exposure, 101);
  const auto exposeRow = [&](int row, std::uint8_t* out) {
    const float dy = static_cast<float>(row) - cy;
    std::uint32_t index =
        static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(sensor.width);
    for (int column = 0; column < sensor.width; ++column, ++index) {
      const float dx = static_cast<float>(column) - cx;
      float level = gain * radiance[index] * (1 - fall * (dx * dx + dy * dy));
      if (noisy) {
        const std::uint32_t h = hash(index ^ stream);
        level += std::sqrt(read + shot * std::max(level, 0.0F)) * normal(h, hash(h + stream));
      }
      if (gamma != 1) level = 255 * std::pow(std::clamp(level / 255, 0.0F, 1.0F), gamma);
      out[column] = static_cast<std::uint8_t>(std::clamp(level + 0.5F, 0.0F, 255.0F));
    }
  };
  return Image::create(sensor.width, sensor.height, PixelFormat::Gray8, [&](std::uint8_t* data) {
    oneapi::tbb::parallel_for(0, sensor.height, [&](int row) {
      exposeRow(row, data + std::ptrdiff_t{row} * sensor.width);
    });
  });
}

}  // namespace tolman::town
