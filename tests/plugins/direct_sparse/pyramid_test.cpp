// SPDX-License-Identifier: BSD-3-Clause
// Levels, their coordinates, and odd sizes.
#include "pyramid.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "street.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

template <class Function>
Image imageOf(int width, int height, Function&& function) {
  return Image::create(width, height, PixelFormat::Gray8, [&](std::uint8_t* data) {
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) *data++ = static_cast<std::uint8_t>(function(u, v));
    }
  });
}

}  // namespace

TEST_CASE("odd widths and heights keep a full pyramid") {
  const int widths[] = {1241, 1226, 1242};
  const int heights[] = {376, 370, 375};
  for (int i = 0; i < 3; ++i) {
    ImagePyramid pyramid;
    pyramid.build(imageOf(widths[i], heights[i], [](int u, int) { return u % 256; }));
    CHECK(pyramid.levels() == 5);
    for (int l = 1; l < pyramid.levels(); ++l) {
      CHECK(pyramid.level(l).width == pyramid.level(l - 1).width / 2);
      CHECK(pyramid.level(l).height == pyramid.level(l - 1).height / 2);
    }
  }
}

TEST_CASE("levels stop where a side gets too small, or where one asks them to") {
  const Image image = imageOf(200, 40, [](int u, int) { return u; });
  ImagePyramid pyramid;
  CHECK(pyramid.empty());
  pyramid.build(image);
  CHECK(pyramid.levels() == 2);
  pyramid.build(image, 1);
  CHECK(pyramid.levels() == 1);
  pyramid.clear();
  CHECK(pyramid.empty());
}

TEST_CASE("a pixel of a level is the mean of four, and noise does not brighten the levels") {
  RandomStream random(3);
  const Image image =
      imageOf(512, 256, [&](int, int) { return 100 + static_cast<int>(random.below(20)); });
  ImagePyramid pyramid;
  pyramid.build(image);
  for (int v = 0; v < 128; v += 17) {
    for (int u = 0; u < 256; u += 13) {
      const std::uint8_t* p = image.row(2 * v) + 2 * u;
      const std::uint8_t* q = image.row(2 * v + 1) + 2 * u;
      const double mean = (p[0] + p[1] + q[0] + q[1]) / 4.0;
      CHECK(std::abs(pyramid.level(1).row(v)[u] - mean) <= 0.5);
    }
  }
  const float bottom = grayStatistics(pyramid.level(0)).mean;
  CHECK(grayStatistics(pyramid.level(3)).mean == Approx(bottom).margin(0.3));
}

TEST_CASE("every column of a level, for any number of columns") {
  for (int columns = 16; columns <= 49; ++columns) {
    RandomStream random(static_cast<std::uint64_t>(columns));
    const Image image = imageOf(2 * columns + columns % 2, 32,
                                [&](int, int) { return static_cast<int>(random.below(256)); });
    ImagePyramid pyramid;
    pyramid.build(image);
    REQUIRE(pyramid.level(1).width == columns);
    for (int v = 0; v < 16; ++v) {
      for (int u = 0; u < columns; ++u) {
        const std::uint8_t* p = image.row(2 * v) + 2 * u;
        const std::uint8_t* q = image.row(2 * v + 1) + 2 * u;
        const double mean = (p[0] + p[1] + q[0] + q[1]) / 4.0;
        // Halves are rounded up in odd columns only.
        const double rounded = u % 2 == 1 ? std::floor(mean + 0.5) : std::ceil(mean - 0.5);
        CHECK(pyramid.level(1).row(v)[u] == static_cast<int>(rounded));
      }
    }
  }
}

TEST_CASE("the same scene point has the same value on all levels at its coordinates there") {
  // A slope is unchanged by averaging, so levels can be compared at any position.
  ImagePyramid pyramid;
  pyramid.build(imageOf(240, 200, [](int u, int) { return u; }));
  for (const float u : {40.0F, 77.5F, 130.25F}) {
    for (int l = 0; l < pyramid.levels(); ++l) {
      CHECK(pyramid.level(l).at(toLevel(u, l), toLevel(90, l)) == Approx(u).margin(0.51));
    }
  }
}

TEST_CASE("bilinear values are exact on a bilinear function, and bounds are kept") {
  const GrayLevel level = test::levelOf(20, 10, [](int u, int v) { return 2 * u + 3 * v + 5; });
  CHECK(level.at(3.25F, 4.5F) == Approx(2 * 3.25 + 3 * 4.5 + 5));
  CHECK(level.contains(0, 0, 0));
  CHECK_FALSE(level.contains(0, 0, 1));
  CHECK(level.contains(18.9F, 8.9F, 0));
  CHECK_FALSE(level.contains(19, 5, 0));
}

TEST_CASE("rows may be padded, and colour becomes grey") {
  std::vector<std::uint8_t> bytes(64 * 3 * 40 + 40 * 5);
  const std::ptrdiff_t stride = 64 * 3 + 5;
  for (int v = 0; v < 40; ++v) {
    for (int u = 0; u < 64; ++u) {
      std::uint8_t* p = bytes.data() + v * stride + 3 * u;
      p[0] = 10;
      p[1] = static_cast<std::uint8_t>(u);
      p[2] = 200;
    }
  }
  ImagePyramid pyramid;
  pyramid.build({bytes.data(), 64, 40, stride, PixelFormat::Bgr8, nullptr});
  for (const int u : {0, 31, 63}) {
    CHECK(pyramid.level(0).row(39)[u] == Approx(0.114 * 10 + 0.587 * u + 0.299 * 200).margin(1));
  }
}

TEST_CASE("contrast tells a covered camera") {
  CHECK(grayStatistics(test::levelOf(64, 64, [](int, int) { return 7; })).deviation == 0);
  const GrayStatistics board =
      grayStatistics(test::levelOf(64, 64, [](int u, int) { return u / 8 % 2 == 0 ? 50 : 150; }));
  CHECK(board.mean == Approx(100));
  CHECK(board.deviation == Approx(50));
}
