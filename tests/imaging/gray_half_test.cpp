// SPDX-License-Identifier: BSD-3-Clause
#include "engine/gray_half.hpp"

#include <catch2/catch.hpp>

using namespace tolman;
using namespace tolman::imaging;

TEST_CASE("each pixel of the half image is the rounded mean of four") {
  const Image image = Image::create(5, 3, PixelFormat::Gray8, [](std::uint8_t* data) {
    for (int i = 0; i < 15; ++i) data[i] = static_cast<std::uint8_t>(10 * i);
  });
  const GrayHalf half = grayHalf(image);  // odd columns and rows at the end are left out
  REQUIRE(half.width == 2);
  REQUIRE(half.height == 1);
  CHECK(half.row(0)[0] == (0 + 10 + 50 + 60 + 2) / 4);
  CHECK(half.row(0)[1] == (20 + 30 + 70 + 80 + 2) / 4);
}

TEST_CASE("of a colour image green is taken, also where rows are padded") {
  auto pixels = std::make_shared<std::vector<std::uint8_t>>(2 * 16, 255);
  for (int r = 0; r < 2; ++r) {
    for (int c = 0; c < 2; ++c) (*pixels)[static_cast<std::size_t>(r * 16 + 3 * c + 1)] = 40;
  }
  const Image image(pixels->data(), 2, 2, 16, PixelFormat::Bgr8, pixels);
  const GrayHalf half = grayHalf(image);
  REQUIRE(half.pixels.size() == 1);
  CHECK(half.pixels[0] == 40);
}

TEST_CASE("an image of one pixel has an empty half") {
  const Image image = Image::create(1, 1, PixelFormat::Gray8, [](std::uint8_t*) {});
  CHECK(grayHalf(image).pixels.empty());
}
