// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "feature_guess.hpp"
#include "textured_pair.hpp"

using namespace tolman::direct_sparse;
using tolman::test::levelOf;
using tolman::test::Texture;

namespace {

constexpr int kMatchWidth = 200;
constexpr int kMatchHeight = 100;

}  // namespace

TEST_CASE("a patch is found at fractions of a pixel, also in a brighter image") {
  const Texture texture(7);
  const GrayLevel here = texture.image(kMatchWidth, kMatchHeight);
  for (const float gain : {1.0F, 0.7F}) {
    for (const double below : {-0.8, -0.3, 0.0, 0.25, 0.6}) {
      const GrayLevel there = texture.displaced(
          kMatchWidth, kMatchHeight, [&](double, double) { return below; },
          static_cast<double>(gain));
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      int found = 0;
      for (int u = 20; u < kMatchWidth - 20; u += 9) {
        for (int v = 15; v < kMatchHeight - 15; v += 9) {
          const Eigen::Vector2f start(static_cast<float>(u), static_cast<float>(v));
          const auto match = matchPatch(here, u, v, there, start, gain, 3);
          if (!match) continue;
          sum += (*match - start).cast<double>();
          ++found;
        }
      }
      CAPTURE(gain, below);
      REQUIRE(found > 40);
      CHECK(std::abs(sum.x() / found) < 0.02);
      CHECK(std::abs(sum.y() / found - below) < 0.03);
    }
  }
}

TEST_CASE("a patch is not found where it cannot be") {
  const Texture texture(8);
  const GrayLevel here = texture.image(kMatchWidth, kMatchHeight);
  CHECK(matchPatch(here, 100, 50, here, {100, 50}, 1, 3));
  // Outside of the images, or another place.
  CHECK_FALSE(matchPatch(here, 2, 50, here, {2, 50}, 1, 3));
  CHECK_FALSE(matchPatch(here, 100, 50, here, {1, 50}, 1, 3));
  CHECK_FALSE(
      matchPatch(here, 100, 50, Texture(9).image(kMatchWidth, kMatchHeight), {100, 50}, 1, 3));
  // Farther than 1.5 px.
  const GrayLevel far =
      texture.displaced(kMatchWidth, kMatchHeight, [](double, double) { return 2.5; });
  CHECK_FALSE(matchPatch(here, 100, 50, far, {100, 50}, 1, 3));
}

TEST_CASE("an edge or an even surface is no corner") {
  const GrayLevel edge =
      levelOf(kMatchWidth, kMatchHeight, [](int u, int) { return u < 100 ? 50 : 200; });
  CHECK_FALSE(matchPatch(edge, 100, 50, edge, {100, 50}, 1, 3));
  const GrayLevel even = levelOf(kMatchWidth, kMatchHeight, [](int, int) { return 128; });
  CHECK_FALSE(matchPatch(even, 100, 50, even, {100, 50}, 1, 3));
}
