// SPDX-License-Identifier: BSD-3-Clause
#include "engine/brightness.hpp"

#include <catch2/catch.hpp>

#include "support/gray_images.hpp"

using namespace tolman;
using namespace tolman::imaging;

TEST_CASE("the brightest value is found wherever it is, in any channel") {
  CHECK(brightest(Image()) == -1);
  CHECK_FALSE(isNearlyBlack(Image()));
  const auto spot = [](int x0, int y0, int value) {
    return test::gray(31, 7, [=](int x, int y) { return x == x0 && y == y0 ? value : 3; });
  };
  CHECK(brightest(spot(30, 6, 200)) == 200);
  CHECK(brightest(spot(0, 0, 64)) == 64);
  CHECK_FALSE(isNearlyBlack(spot(0, 0, 64)));
  CHECK(isNearlyBlack(spot(30, 6, 63)));
  const Image blue =
      Image::create(5, 4, PixelFormat::Bgr8, [](std::uint8_t* pixels) { pixels[3 * 19 + 2] = 99; });
  CHECK(brightest(blue) == 99);
  CHECK(brightest(test::gray(3, 3, [](int, int) { return 0; })) == 0);
}

TEST_CASE("one in ten thousand pixels may be white in an image that is nearly black") {
  const auto withWhite = [](int white) {
    return test::gray(200, 100, [=](int x, int y) { return y == 0 && x < white ? 255 : 15; });
  };
  CHECK(brightest(withWhite(2)) == 15);
  CHECK(isNearlyBlack(withWhite(2)));
  CHECK(brightest(withWhite(3)) == 255);
  CHECK_FALSE(isNearlyBlack(withWhite(3)));
}
