// SPDX-License-Identifier: BSD-3-Clause
// Sensor, bloom, rain.
#include "image_formation.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman;
using namespace tolman::town;

namespace {

struct Moments {
  double mean = 0;
  double variance = 0;
};

Moments momentsOf(const Image& image) {
  double sum = 0;
  double squares = 0;
  for (int row = 0; row < image.height(); ++row) {
    for (int column = 0; column < image.width(); ++column) {
      const double v = image.row(row)[column];
      sum += v;
      squares += v * v;
    }
  }
  const double count = double(image.width()) * image.height();
  return {sum / count, squares / count - (sum / count) * (sum / count)};
}

Sensor plain() {
  Sensor sensor;
  sensor.width = 300;
  sensor.height = 200;
  return sensor;
}

}  // namespace

TEST_CASE("without noise a grey level is gain times radiance, rounded and clipped") {
  Sensor sensor = plain();
  std::vector<float> radiance(60000, 0.4F);
  radiance[0] = 7;
  const Image image = expose(sensor, radiance, 0);
  CHECK(int(image.row(0)[0]) == 255);
  CHECK(int(image.row(100)[100]) == 102);
}

TEST_CASE("noise has variance read^2 + shot * level, and a rounding step's") {
  Sensor sensor = plain();
  sensor.read_noise = 0.8;
  sensor.shot_noise = 0.015;
  for (const float level : {40.0F, 150.0F}) {
    const Moments m = momentsOf(expose(sensor, std::vector<float>(60000, level / 255), 3));
    CHECK(m.mean == Approx(level).margin(0.03));
    CHECK(m.variance == Approx(0.64 + 0.015 * double(level) + 1.0 / 12).epsilon(0.03));
  }
}

TEST_CASE("noise differs between exposures and runs, and repeats for the same ones") {
  Sensor sensor = plain();
  sensor.read_noise = 2;
  const std::vector<float> radiance(60000, 0.5F);
  const auto bytes = [&](std::uint32_t seed, std::uint32_t exposure) {
    sensor.seed = seed;
    const Image image = expose(sensor, radiance, exposure);
    return std::vector<std::uint8_t>(image.data(), image.data() + 60000);
  };
  CHECK(bytes(1, 0) == bytes(1, 0));
  CHECK(bytes(1, 0) != bytes(1, 1));
  CHECK(bytes(1, 0) != bytes(2, 0));
  // Left and right noise are independent: correlation of the two fields is that of chance.
  const auto a = bytes(1, 0);
  const auto b = bytes(1, 1);
  double product = 0;
  for (std::size_t i = 0; i < a.size(); ++i) product += (a[i] - 127.5) * (b[i] - 127.5);
  CHECK(std::abs(product / 60000) < 5 * 4.0 / std::sqrt(60000));
}

TEST_CASE("vignetting darkens the corners by the share asked for") {
  Sensor sensor = plain();
  sensor.vignetting = 0.3;
  const Image image = expose(sensor, std::vector<float>(60000, 0.8F), 0);
  CHECK(int(image.row(0)[0]) == std::lround(0.8 * 255 * 0.7));
  CHECK(int(image.row(100)[150]) == std::lround(0.8 * 255));
}

namespace {

constexpr int kSide = 201;
constexpr std::size_t kMiddle = kSide * (kSide / 2) + kSide / 2;

std::vector<float> spot(float radiance) {
  std::vector<float> image(kSide * kSide, 0.25F);
  image[kMiddle] = radiance;
  return image;
}

double total(const std::vector<float>& image) {
  double sum = 0;
  for (const float value : image) sum += static_cast<double>(value);
  return sum;
}

}  // namespace

TEST_CASE("below saturation nothing blooms") {
  std::vector<float> image = spot(0.9F);
  addBloom(image, {kSide, kSide, 1}, 1, 0.5F);
  CHECK(image == spot(0.9F));
}

TEST_CASE("the share of the excess goes to the pixels around, less with distance") {
  std::vector<float> image = spot(51);
  addBloom(image, {kSide, kSide, 1}, 1, 0.1F);
  CHECK(total(image) - total(spot(51)) == Approx(0.1 * 50).epsilon(0.01));
  CHECK(image[kMiddle + 2] > image[kMiddle + 6]);
  CHECK(image[kMiddle + 6] > image[kMiddle + 60]);
  CHECK(image[kMiddle + 60] > 0.25F);
  CHECK(image[kMiddle + 90] == 0.25F);
}

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

TEST_CASE("less light is exposed longer, and amplified beyond the longest time") {
  const auto at = [](double hour, std::vector<double> ms) {
    return exposureFor(makeLight(hour, Weather::Clear, 0, 1), ms);
  };
  CHECK(at(23, {0}).time_ms == 0);
  CHECK(at(23, {30}).time_ms == 30);
  CHECK(at(23, {30}).amplification == 1);
  CHECK(at(12, {0.5, 2}).time_ms == Approx(0.5));
  CHECK(at(12, {0.5, 2}).amplification == Approx(1));
  CHECK(at(18, {0.5, 2}).time_ms > 0.55);
  const Exposure night = at(0, {0.5, 2});
  CHECK(night.time_ms == 2);
  // Time times amplification grows as the light shrinks.
  const auto light = [](double hour) {
    return static_cast<double>(makeLight(hour, Weather::Clear, 0, 1).onto({0, 0, 1}, 1));
  };
  CHECK(night.time_ms * night.amplification == Approx(0.5 * light(12) / light(0)).epsilon(1e-4));
}
