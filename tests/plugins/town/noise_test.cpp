// SPDX-License-Identifier: BSD-3-Clause
// Noise of single points and of eight at once.
#include "noise.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "lanes.hpp"

using namespace tolman::town;

namespace {

/// Mean square of fractal2 over a patch, for a pixel of `footprint` m.
double power(float footprint) {
  double sum = 0;
  constexpr int kCount = 4000;
  for (int i = 0; i < kCount; ++i) {
    const float x = 0.173F * static_cast<float>(i);
    const float y = 0.311F * static_cast<float>(i % 97);
    const double n = static_cast<double>(fractal2(x, y, 1, 4, footprint, 7));
    sum += n * n;
  }
  return sum / kCount;
}

}  // namespace

TEST_CASE("noise stays in [-1, 1], has zero mean, and depends on its seed") {
  double sum = 0;
  int differing = 0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const float x = -900 + 0.37F * static_cast<float>(i);
    const float y = 0.59F * static_cast<float>(i % 331) - 80;
    const float n = noise2(x, y, 3);
    REQUIRE(std::abs(n) <= 1);
    sum += static_cast<double>(n);
    differing += n != noise2(x, y, 4);
  }
  CHECK(std::abs(sum / kCount) < 0.02);
  CHECK(differing > kCount * 99 / 100);
}

TEST_CASE("noise is continuous, across lattice lines and at negative coordinates too") {
  for (int i = 0; i < 4000; ++i) {
    const float x = -10 + 0.005F * static_cast<float>(i);
    REQUIRE(std::abs(noise2(x + 1e-3F, -2.5F, 1) - noise2(x, -2.5F, 1)) < 5e-3F);
    REQUIRE(std::abs(noise3({x + 1e-3F, 4.1F, -0.3F}, 1) - noise3({x, 4.1F, -0.3F}, 1)) < 6e-3F);
  }
}

TEST_CASE("a coarser pixel never sees more texture, and in the end none") {
  double before = power(0.001F);
  CHECK(before > 0.02);
  for (const float footprint : {0.02F, 0.05F, 0.1F, 0.2F, 0.4F, 0.7F}) {
    const double now = power(footprint);
    CHECK(now <= before + 1e-9);
    before = now;
  }
  CHECK(before == 0);
}

TEST_CASE("noise and hashes of eight points are those of each of them") {
  const Eight x = {-3.2F, 0, 1.5F, 77.1F, -0.01F, 12, 1e4F, -1e4F};
  const Eight y = {4, -7.7F, 0.3F, 1e3F, 2.5F, -0.5F, 0, 9};
  const Eight flat = noise2(x, y, 9U);
  const Eight solid = noise3(Vec3s{x, y, -x}, 9U);
  const EightWords hashes = hash(words(truncated(x)), words(truncated(y)), 9);
  for (int i = 0; i < kLanes; ++i) {
    CHECK(flat[i] == noise2(x[i], y[i], 9));
    CHECK(solid[i] == noise3(Vec3{x[i], y[i], -x[i]}, 9));
    CHECK(hashes[i] == hash(words(truncated(x))[i], words(truncated(y))[i], 9));
  }
}

TEST_CASE("lanes: square roots, floors and powers of e are those of the library") {
  for (int i = 0; i < 400; ++i) {
    const float x = -79 + 0.197F * static_cast<float>(i);
    CHECK(exponential(eight(x))[i % kLanes] == Approx(std::exp(x)).epsilon(2e-7 * (1 - x)));
    CHECK(floorOf(eight(x))[i % kLanes] == std::floor(x));
    CHECK(squareRoot(eight(-x))[i % kLanes] == std::sqrt(-x));
  }
  CHECK(exponential(eight(0))[0] == 1);
  CHECK(exponential(eight(-1e9F))[0] < 1e-34F);
}

TEST_CASE("octaves computed side by side are the sum of single ones") {
  for (int i = 0; i < 500; ++i) {
    const float x = -31 + 0.713F * static_cast<float>(i);
    const float y = 7 - 0.291F * static_cast<float>(i);
    const float z = 0.117F * static_cast<float>(i) - 20;
    float flat = 0;
    float solid = 0;
    float amplitude = 0.55F;
    float wavelength = 1.7F;
    for (std::uint32_t octave = 0; octave < 3; ++octave, wavelength /= 2, amplitude *= 0.7F) {
      const float weight = amplitude * survives(wavelength, 0.15F);
      flat += weight * noise2(x / wavelength, y / wavelength, 40 + octave);
      solid += weight * noise3(Vec3{x, y, z} * (1 / wavelength), 40 + octave);
    }
    REQUIRE(fractal2(x, y, 1.7F, 3, 0.15F, 40) == Approx(flat).margin(2e-3));
    REQUIRE(fractal2(eight(x), eight(y), 1.7F, 3, eight(0.15F), 40U)[5] ==
            Approx(flat).margin(2e-3));
    REQUIRE(fractal3(vec3s({x, y, z}), 1.7F, 3, eight(0.15F), 40U)[3] ==
            Approx(solid).margin(2e-3));
  }
  const float mean = (noise2(1.2F, 3.4F, 5) + noise2(1.3F, 3.2F, 5) + noise2(1.4F, 3.0F, 5)) / 3;
  const Eight taps = {1, 2, 3, 4, 1, 2, 3, 4};
  const Eight means = meanNoise2(eight(1.2F), eight(3.4F), eight(0.1F), eight(-0.2F), taps, 5U);
  CHECK(means[2] == Approx(mean).margin(1e-5));
  CHECK(means[4] == Approx(noise2(1.2F, 3.4F, 5)).margin(1e-5));
}
