// SPDX-License-Identifier: BSD-3-Clause
// The field of displacements: its size, smoothness, independence; and what it does to rays.
#include "pixel_warp.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "small_town.hpp"

using namespace tolman;
using namespace tolman::town;
using tolman::town::test::SmallTown;

TEST_CASE("no error, no warp") { CHECK(makeWarp(100, 50, 0, 1).isEmpty()); }

TEST_CASE("a warp has the wanted rms, no mean, and is smooth") {
  constexpr int kWidth = 200;
  constexpr int kHeight = 60;
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const PixelWarp warp = makeWarp(kWidth, kHeight, 0.7, seed);
    REQUIRE(warp.x.size() == kWidth * kHeight);
    REQUIRE(warp.y.size() == kWidth * kHeight);
    double squares = 0;
    double mean = 0;
    double steepest = 0;
    for (std::size_t i = 0; i < warp.x.size(); ++i) {
      const auto x = static_cast<double>(warp.x[i]);
      const auto y = static_cast<double>(warp.y[i]);
      squares += (x * x + y * y) / (kWidth * kHeight);
      mean += x / (kWidth * kHeight);
      if (i % kWidth == 0) continue;
      steepest = std::max(steepest, std::abs(x - static_cast<double>(warp.x[i - 1])));
    }
    CHECK(std::sqrt(squares) == Approx(0.7).epsilon(1e-4));
    CHECK(std::abs(mean) < 1e-4);
    CHECK(steepest < 0.7 * 10 * 3.2 / kWidth);  // three half periods over the width
  }
}

TEST_CASE("seeds give other warps") {
  const PixelWarp a = makeWarp(64, 64, 1, 1);
  CHECK(a.x == makeWarp(64, 64, 1, 1).x);
  CHECK(a.x != makeWarp(64, 64, 1, 2).x);
  CHECK(a.x != a.y);
}

TEST_CASE("a constant warp renders what a moved principal point renders") {
  const SmallTown town;
  RenderCamera moved = SmallTown::view(town.route.T_town_camera[40]);
  RenderCamera warped = moved;
  moved.pinhole.cx -= 3;
  moved.pinhole.cy += 2;
  const auto pixels = static_cast<std::size_t>(moved.width * moved.height);
  const PixelWarp warp = {std::vector<float>(pixels, 3), std::vector<float>(pixels, -2)};
  warped.warp = &warp;
  const RenderedImage a = town.picture(moved);
  const RenderedImage b = town.picture(warped);
  std::size_t same = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    same += std::abs(a.radiance[i] - b.radiance[i]) < 0.01F &&
            std::abs(a.depth[i] - b.depth[i]) < 0.01F * a.depth[i] + 0.01F;
  }
  CHECK(static_cast<double>(same) > 0.99 * static_cast<double>(pixels));
}
