// SPDX-License-Identifier: BSD-3-Clause
#include "rain_streaks.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman::town;

namespace {

RenderCamera view() {
  RenderCamera view;
  view.width = 310;
  view.height = 94;
  view.pinhole = {180, 180, 152, 46};
  return view;
}

std::vector<float> after(const Rain& rain, double right_m = 0) {
  std::vector<float> radiance(310 * 94, 0.1F);
  Eigen::Isometry3d T_left_camera = Eigen::Isometry3d::Identity();
  T_left_camera.translation().x() = right_m;
  addRain(radiance, view(), T_left_camera, rain);
  return radiance;
}

int changed(const std::vector<float>& radiance) {
  int count = 0;
  for (const float value : radiance) count += value != 0.1F;
  return count;
}

}  // namespace

TEST_CASE("more rain changes more pixels, towards the brightness of the sky") {
  Rain rain;
  rain.brightness = 0.6F;
  CHECK(changed(after(rain)) == 0);
  rain.density = 0.3F;
  const int some = changed(after(rain));
  rain.density = 1;
  const std::vector<float> heavy = after(rain);
  CHECK(some > 50);
  CHECK(changed(heavy) > 2 * some);
  CHECK(changed(heavy) < 310 * 94 / 3);
  for (const float value : heavy) {
    CHECK(value >= 0.1F);
    CHECK(value <= 0.6F);
  }
  rain.exposure_s *= 4;
  CHECK(changed(after(rain)) > changed(heavy));
}

TEST_CASE("the drops are those of the moment, seen from where the camera is") {
  Rain rain;
  rain.density = 1;
  rain.brightness = 0.6F;
  CHECK(after(rain) == after(rain));
  CHECK(after(rain) != after(rain, 0.5));
  rain.seed = 2;
  CHECK(after(rain) != after(Rain{1, 0.6F, rain.exposure_s, rain.speed_m_s, 0}));
}
