// SPDX-License-Identifier: BSD-3-Clause
// The image sensor: mean, shot noise, vignetting, saturation.
#include "sensor.hpp"

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

TEST_CASE("gamma bends the response between black and saturation") {
  Sensor sensor = plain();
  sensor.gamma = 0.5;
  std::vector<float> radiance(60000, 0.25F);
  radiance[0] = 0;
  radiance[1] = 1;
  radiance[2] = 4;
  const Image image = expose(sensor, radiance, 0);
  CHECK(int(image.row(0)[0]) == 0);
  CHECK(int(image.row(0)[1]) == 255);
  CHECK(int(image.row(0)[2]) == 255);
  CHECK(int(image.row(100)[100]) == 128);
}
