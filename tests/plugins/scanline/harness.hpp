// SPDX-License-Identifier: BSD-3-Clause
// Cameras that turn in front of a distant panorama, and a configured plugin for their images.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scanline.hpp"
#include "support/context.hpp"

namespace tolman::scanline::test {

constexpr std::int64_t kStep = 100'000'000;  // ns

inline CameraRig pinholeRig(int width = 320, int height = 120, double focal = 200) {
  CameraRig rig{width, height, true, {}, 0};
  rig.pinhole = {focal, focal, (width - 1) / 2.0, (height - 1) / 2.0};
  return rig;
}

inline CameraRig unknownRig(int width = 320, int height = 120) {
  return {width, height, false, {}, 0};
}

inline Image gray(int width, int height, auto&& value) {
  return Image::create(width, height, PixelFormat::Gray8, [&](std::uint8_t* pixel) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) *pixel++ = static_cast<std::uint8_t>(value(x, y));
    }
  });
}

/// Brightness by azimuth (rad, positive to the left).
inline double panorama(double azimuth) {
  double value = 128;
  for (int k = 3; k < 40; k += 4) value += 11 * std::sin(k * azimuth + 1.7 * k * k);
  return std::clamp(value, 0.0, 255.0);
}

/// What a camera with heading `yaw` sees: a pinhole where it is calibrated, otherwise the same
/// angle with each of its columns, `field_of_view` (rad) in all.
inline Image view(const CameraRig& rig, double yaw, double field_of_view = 1.0, double gain = 1) {
  return gray(rig.width, rig.height, [&](int x, int) {
    const double right = rig.calibrated ? std::atan((x - rig.pinhole.cx) / rig.pinhole.fx)
                                        : (x - 0.5 * (rig.width - 1)) * field_of_view / rig.width;
    return std::lround(std::clamp(gain * panorama(yaw - right), 0.0, 255.0));
  });
}

/// Wide regions: the panorama is the same in every row.
inline ParameterValues whole(ParameterValues more = {}) {
  more.try_emplace("turn_region", std::vector<double>{0, 1, 0.2, 0.5});
  return more;
}

class Host {
 public:
  explicit Host(const CameraRig& rig, const ParameterValues& values = {}) : services_(values) {
    services_.rig = rig;
    configured_ = plugin.configure(services_);
  }
  const Status& configured() const { return configured_; }
  Motion see(const Image& image, std::int64_t step_ns = kStep) {
    Frame frame;
    frame.frame = next_++;
    frame.stamp_ns = stamp_ns_ += step_ns;
    frame.left = image;
    Motion motion;
    const Status status = plugin.track(frame, motion);
    if (!status.isOk()) throw std::runtime_error(status.message());
    return motion;
  }

  Scanline plugin;

 private:
  tolman::test::TestContext services_;
  Status configured_;
  std::int64_t next_ = 0;
  std::int64_t stamp_ns_ = 5'000'000'000;
};

}  // namespace tolman::scanline::test
