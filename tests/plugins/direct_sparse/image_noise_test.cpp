// SPDX-License-Identifier: BSD-3-Clause
// Oracles: noise of known deviation, and the noise that a binomial filter leaves by theory.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "pyramid.hpp"

using namespace tolman::direct_sparse;

namespace {

/// `scene(u, v)` with normally distributed noise.
template <class Scene>
GrayLevel noisy(double deviation, Scene&& scene) {
  GrayLevel image;
  image.resize(301, 203);
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 1);
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      const double grey = scene(u, v) + deviation * noise(random);
      image.row(v)[u] = static_cast<std::uint8_t>(std::clamp(std::lround(grey), 0L, 255L));
    }
  }
  return image;
}

double flat(int, int) { return 120; }
double slope(int u, int v) { return 60 + 0.2 * u + 0.3 * v; }
/// A board of squares of 24 px: edges are on a sixth of the pixels.
double board(int u, int v) { return (u / 24 + v / 24) % 2 == 0 ? 60 : 180; }

double deviationOf(const GrayLevel& image) {
  double sum = 0;
  double squares = 0;
  double count = 0;
  for (int v = 1; v + 1 < image.height; ++v) {
    for (int u = 1; u + 1 < image.width; ++u, ++count) {
      sum += image.row(v)[u];
      squares += image.row(v)[u] * image.row(v)[u];
    }
  }
  const double mean = sum / count;
  return std::sqrt(squares / count - mean * mean);
}

}  // namespace

TEST_CASE("noise is measured in spite of slopes and edges") {
  for (const double deviation : {1.5, 3.0, 5.0, 8.0}) {
    CHECK(imageNoise(noisy(deviation, flat)) == Approx(deviation).epsilon(0.06));
    CHECK(imageNoise(noisy(deviation, slope)) == Approx(deviation).epsilon(0.06));
    CHECK(imageNoise(noisy(deviation, board)) == Approx(deviation).epsilon(0.2));
  }
}

TEST_CASE("images without noise, or without usable pixels, have none") {
  CHECK(imageNoise(noisy(0, flat)) < 0.3F);  // of rounding
  CHECK(imageNoise(noisy(0, board)) < 0.3F);
  CHECK(imageNoise(noisy(0, [](int, int) { return 0; })) == 0);
  CHECK(imageNoise(noisy(0, [](int, int) { return 255; })) == 0);
  CHECK(imageNoise(GrayLevel()) == 0);
}

TEST_CASE("only noisy images are smoothed") {
  CHECK(smoothedShare(0) == 0);
  CHECK(smoothedShare(2.3F) == 0);
  CHECK(smoothedShare(3) > 0);
  CHECK(smoothedShare(3) < smoothedShare(3.5F));
  CHECK(smoothedShare(5) == 1);
}

TEST_CASE("smoothing leaves three eighths of the noise, and slopes") {
  std::vector<std::uint8_t> buffer;
  GrayLevel image = noisy(8, flat);
  smooth(image, 1, buffer);
  CHECK(deviationOf(image) == Approx(8 * 0.375).epsilon(0.03));  // of 1 2 1 in both directions
  GrayLevel plane = noisy(0, slope);
  const GrayLevel original = plane;
  smooth(plane, 1, buffer);
  for (std::size_t i = 0; i < original.pixels.size(); ++i) {
    REQUIRE(std::abs(plane.pixels[i] - original.pixels[i]) <= 1);
  }
  smooth(plane, 0, buffer);
  GrayLevel same = original;
  smooth(same, 0, buffer);
  CHECK(same.pixels == original.pixels);
}
