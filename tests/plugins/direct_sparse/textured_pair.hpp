// SPDX-License-Identifier: BSD-3-Clause
// A stereo pair of a smooth texture whose right image is displaced by a known function.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "street.hpp"
#include "tolman/context.hpp"

namespace tolman::test {

/// Waves of many lengths and directions, none shorter than 7 px, in grey levels.
class Texture {
 public:
  explicit Texture(std::uint64_t seed) {
    RandomStream random(seed);
    for (Wave& wave : waves_) {
      wave = {random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6), random.uniform(0, 6.28)};
    }
  }
  double at(double u, double v) const {
    double sum = 0;
    for (const Wave& wave : waves_) sum += std::sin(wave.fu * u + wave.fv * v + wave.phase);
    return 125 + 8 * sum;
  }
  direct_sparse::GrayLevel image(int width, int height) const {
    return displaced(width, height, [](double, double) { return 0.0; });
  }
  /// A point that `image` shows at (u, v) is here at (u, v + below(u, v)), for small and smooth
  /// displacements: the texture at v - below(u, v).
  template <class Below>
  direct_sparse::GrayLevel displaced(int width, int height, Below&& below, double gain = 1) const {
    return levelOf(width, height, [&](int u, int v) {
      return std::lround(std::clamp(gain * at(u, v - below(u, v)), 0.0, 255.0));
    });
  }

 private:
  struct Wave {
    double fu, fv, phase;
  };
  Wave waves_[40];
};

}  // namespace tolman::test
