// SPDX-License-Identifier: BSD-3-Clause
// A configured view_templates plugin and small images for its tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "support/context.hpp"
#include "support/gray_images.hpp"
#include "view_templates.hpp"

namespace tolman::view_templates::test {

inline Status configure(ViewTemplates& plugin, const ParameterValues& parameters) {
  tolman::test::TestContext services(parameters);
  return plugin.configure(services);
}

using tolman::test::gray;
using tolman::test::noise;

/// Shows one image to the plugin as frame `frame`.
inline PlaceObservation observe(ViewTemplates& plugin, const Image& image, std::int64_t frame = 0) {
  Frame input;
  input.frame = frame;
  input.stamp_ns = 1000 * frame;
  input.left = image;
  PlaceObservation observation;
  const Status status = plugin.observe(input, nullptr, observation);
  if (!status.isOk()) throw std::runtime_error(status.message());
  return observation;
}

/// A far-away panorama: brightness by azimuth (rad, positive to the left) and elevation.
inline double panorama(double azimuth, double elevation) {
  double value = 120 + 20 * std::sin(9 * elevation);
  for (int k = 2; k < 40; k += 3) value += 12 * std::sin(k * azimuth + 1.7 * k * k);
  return std::clamp(value, 0.0, 255.0);
}

/// What a pinhole camera with heading `yaw` sees of it.
inline Image pinholeView(int width, int height, double focal, double yaw) {
  return gray(width, height, [&](int x, int y) {
    const double right = (x - 0.5 * (width - 1)) / focal;
    const double down = (y - 0.5 * (height - 1)) / focal;
    return std::lround(panorama(yaw - std::atan(right), -std::atan(down / std::hypot(1, right))));
  });
}

}  // namespace tolman::view_templates::test
