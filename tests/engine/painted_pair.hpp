// SPDX-License-Identifier: BSD-3-Clause
// Stereo pairs of a synthetic scene: smooth random texture at depths that increase towards the top.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>

#include "tolman/context.hpp"
#include "tolman/image.hpp"

namespace tolman::test {

struct PaintedPair {
  static constexpr int kWidth = 640;
  static constexpr int kHeight = 200;

  double rows_low = 0;   ///< px, of the right image
  double scattered = 0;  ///< px: each band of rows of the right image is off by up to this
  bool exchanged = false;
  double turned = 0;    ///< px, by which everything is farther left
  double brighter = 0;  ///< grey levels, the right image
  std::uint64_t seed = 1;

  Image left() const {
    return paint([](double) { return 0.0; }, [](double) { return 0.0; }, 0);
  }
  Image right() const {
    const double sign = exchanged ? -1 : 1;
    return paint([=](double y) { return sign * (4 + 40 * y / kHeight); },
                 [=, this](double y) {
                   const int band = static_cast<int>(y) / 25;
                   return rows_low + scattered * (band % 2 == 0 ? 1 : -1) * (0.4 + 0.1 * band);
                 },
                 brighter);
  }

 private:
  /// Value noise, four octaves from 32 px down to 4 px.
  double texture(double x, double y) const {
    double sum = 0;
    for (int octave = 0; octave < 4; ++octave) {
      const double size = 32 >> octave;
      const double gx = x / size;
      const double gy = y / size;
      const double fx = gx - std::floor(gx);
      const double fy = gy - std::floor(gy);
      const auto at = [&](int i, int j) {
        return lattice(octave, std::floor(gx) + i, std::floor(gy) + j);
      };
      sum += (at(0, 0) * (1 - fx) + at(1, 0) * fx) * (1 - fy) +
             (at(0, 1) * (1 - fx) + at(1, 1) * fx) * fy;
    }
    return sum;
  }
  double lattice(int octave, double i, double j) const {
    const auto key =
        static_cast<std::uint64_t>(octave) * 0x9e3779b97f4a7c15ULL ^
        static_cast<std::uint64_t>(static_cast<std::int64_t>(i)) * 0xc2b2ae3d27d4eb4fULL ^
        static_cast<std::uint64_t>(static_cast<std::int64_t>(j)) * 0x165667b19e3779f9ULL;
    return RandomStream(seed ^ key).uniform(-30, 30);
  }
  Image paint(const std::function<double(double)>& disparity,
              const std::function<double(double)>& down, double offset) const {
    return Image::create(kWidth, kHeight, PixelFormat::Gray8, [&](std::uint8_t* data) {
      for (int y = 0; y < kHeight; ++y) {
        const double scene_y = y - down(y);
        for (int x = 0; x < kWidth; ++x) {
          const double value = 128 + offset + texture(x + turned + disparity(scene_y), scene_y);
          *data++ = static_cast<std::uint8_t>(std::fmin(255, std::fmax(0, value)));
        }
      }
    });
  }
};

}  // namespace tolman::test
