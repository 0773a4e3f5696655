// SPDX-License-Identifier: BSD-3-Clause
// Edges by direction: of stripes with a known direction, and in another light.
#include "edge_map.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "support/gray_images.hpp"
#include "support/street_scene.hpp"
#include "tolman/image_cv.hpp"

using namespace tolman;
using namespace tolman::landmarks;
using namespace tolman::test;

namespace {

/// Stripes whose grey level changes along `angle`.
Image stripes(double angle, double amplitude) {
  return gray(160, 80, [&](int x, int y) {
    return 120 + amplitude * std::sin(0.6 * (x * std::cos(angle) + y * std::sin(angle)));
  });
}

}  // namespace

TEST_CASE("stripes have the edges of their direction, whichever side is brighter") {
  for (int k = 0; k < EdgeMap::kDirections; ++k) {
    for (const double amplitude : {60.0, -60.0}) {
      const double angle = (k + 0.5) * std::numbers::pi / EdgeMap::kDirections;
      const EdgeMap map(asMat(stripes(angle, amplitude)));
      CAPTURE(k, amplitude);
      for (int other = 0; other < EdgeMap::kDirections; ++other) {
        const float strength = *map.at(other, 20, 40);
        if (other == k) {
          CHECK(strength * strength > 0.9F * map.energyAt(20, 40));
        } else {
          CHECK(strength * strength < 0.1F * map.energyAt(20, 40));
        }
      }
    }
  }
}

TEST_CASE("an edge twice as steep is twice as strong, and where nothing is there is none") {
  const EdgeMap weak(asMat(stripes(0, 10)));
  const EdgeMap strong(asMat(stripes(0, 20)));
  CHECK(strong.energyAt(20, 40) == Approx(2 * weak.energyAt(20, 40)).epsilon(0.1));
  const EdgeMap none(asMat(filled(90)));
  for (int c = 0; c < none.columns(); ++c) CHECK(none.energyAt(none.rows() / 2, c) < 1e-3F);
  // Outside the image, too, as far as patches reach.
  CHECK(*strong.at(5, -EdgeMap::kMargin, strong.columns() + EdgeMap::kMargin - 1) == 0);
}

TEST_CASE("a brighter image of the same scene has the same edges") {
  const Image image = stripes(0.7, 60);
  const EdgeMap map(asMat(image));
  const EdgeMap dim(asMat(changed(image, 0.4, 0)));
  for (int r = 5; r < map.rows() - 5; r += 3) {
    for (int c = 5; c < map.columns() - 5; c += 3) {
      CHECK(dim.energyAt(r, c) == Approx(map.energyAt(r, c)).epsilon(0.2));
    }
  }
}

TEST_CASE("wide images are reduced; cells and pixels are converted back and forth") {
  for (const auto& [width, factor] :
       {std::pair{310, 1}, {621, 1}, {752, 1}, {1241, 2}, {1920, 3}}) {
    const EdgeMap map(asMat(gray(width, 90, [](int x, int y) { return (x * y) % 200; })));
    CHECK(map.factor() == factor);
    CHECK(map.columns() == width / factor / 2);
    CHECK(map.rows() == 90 / factor / 2);
    for (const cv::Point2f pixel : {cv::Point2f(3.25F, 7.5F), cv::Point2f(100, 40)}) {
      const cv::Point2f back = map.pixelOf(map.cellOf(pixel));
      CHECK(back.x == Approx(pixel.x).margin(1e-4));
      CHECK(back.y == Approx(pixel.y).margin(1e-4));
    }
    // The middle of a cell's 2 x 2 reduced pixels.
    CHECK(map.pixelOf({0, 0}).x == Approx(factor - 0.5));
  }
}
