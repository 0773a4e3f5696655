// SPDX-License-Identifier: BSD-3-Clause
// Dirt and drops: the changed part of the image, and its duration.
#include "lens_glass.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman::town;

namespace {

constexpr int kWidth = 620;
constexpr int kHeight = 188;
const GlassSize kSize = {kWidth, kHeight, 0.5};

/// A ramp, so that refraction shows.
std::vector<float> ramp() {
  std::vector<float> radiance;
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      radiance.push_back(0.2F + static_cast<float>(column) / kWidth);
    }
  }
  return radiance;
}

double changed(const std::vector<float>& a, const std::vector<float>& b) {
  double count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += std::abs(a[i] - b[i]) > 1e-5F;
  return count / static_cast<double>(a.size());
}

std::vector<float> seenThrough(const LensGlass& glass, double seconds) {
  std::vector<float> radiance = ramp();
  glass.apply(radiance, 0.1F, seconds);
  return radiance;
}

}  // namespace

TEST_CASE("clean glass changes nothing") {
  const LensGlass glass(kSize, 0, 0, 1);
  CHECK(glass.isClean());
  CHECK(seenThrough(glass, 3) == ramp());
  CHECK(LensGlass().isClean());
}

TEST_CASE("dirt dims the share asked for, and stays where it is") {
  for (const double share : {0.05, 0.3}) {
    const LensGlass glass(kSize, share, 0, 7);
    CHECK_FALSE(glass.isClean());
    const std::vector<float> seen = seenThrough(glass, 0);
    CHECK(changed(seen, ramp()) == Approx(share).epsilon(0.1));
    CHECK(seenThrough(glass, 100) == seen);
    CHECK(seenThrough(LensGlass(kSize, share, 0, 8), 0) != seen);
  }
}

TEST_CASE("a drop shows what is behind it the other way round") {
  const LensGlass glass(kSize, 0, 12, 3);
  const std::vector<float> seen = seenThrough(glass, 0);
  CHECK(changed(seen, ramp()) > 0.002);
  CHECK(changed(seen, ramp()) < 0.2);
  int falling = 0;  // the ramp rises everywhere else
  for (std::size_t i = 1; i < seen.size(); ++i) {
    falling += i % kWidth != 0 && seen[i] < seen[i - 1] - 1e-4F;
  }
  CHECK(falling > 100);
}

TEST_CASE("drops stay for seconds, not for the drive") {
  const LensGlass glass(kSize, 0, 12, 3);
  CHECK(changed(seenThrough(glass, 0), seenThrough(glass, 0.1)) < 0.02);
  CHECK(seenThrough(glass, 0) != seenThrough(glass, 9));
  CHECK(seenThrough(glass, 5) == seenThrough(glass, 5));
}
