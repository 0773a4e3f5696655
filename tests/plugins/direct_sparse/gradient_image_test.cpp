// SPDX-License-Identifier: BSD-3-Clause
// Values and gradients from one interpolation.
#include "gradient_image.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

TEST_CASE("gradients of a plane are its slopes, anywhere inside") {
  GradientImage image;
  image.build(test::levelOf(60, 20, [](int u, int v) { return 200 - 3 * u + 2 * v; }));
  for (const float u : {2.0F, 7.25F, 40.75F}) {
    const GradientSample sample = image.at(u, 9.5F);
    CHECK(sample.value == Approx(200 - 3 * u + 2 * 9.5F));
    CHECK(sample.gx == Approx(-3));
    CHECK(sample.gy == Approx(2));
  }
  CHECK(image.gradientSquared(10, 10) == Approx(13));
}

TEST_CASE("values agree with the grey level's own, gradients with its central differences") {
  const Frame frame = test::streetFrame(0, test::streetPose(0));
  ImagePyramid pyramid;
  pyramid.build(frame.left);
  const GrayLevel& level = pyramid.level(0);
  GradientImage image;
  image.build(level);
  for (float u = 5.3F; u < 470; u += 37.7F) {
    for (float v = 4.1F; v < 190; v += 23.9F) {
      const GradientSample sample = image.at(u, v);
      // Positions are rounded to 1/128 px, which the gradient turns into grey levels.
      const float gx = 0.5F * (level.at(u + 1, v) - level.at(u - 1, v));
      const float gy = 0.5F * (level.at(u, v + 1) - level.at(u, v - 1));
      CHECK(sample.value == Approx(level.at(u, v)).margin(0.3));
      CHECK(sample.gx == Approx(gx).margin(0.3));
      CHECK(sample.gy == Approx(gy).margin(0.3));
    }
  }
}

TEST_CASE("every pixel of any width: grey value and both differences, none at the border") {
  for (const int width : {16, 17, 21, 24, 31, 50}) {
    const GrayLevel level =
        test::levelOf(width, 9, [](int u, int v) { return (u * u * 37 + v * 91 + u * v) % 256; });
    GradientImage image;
    image.build(level);
    for (int v = 0; v < level.height; ++v) {
      for (int u = 0; u < level.width; ++u) {
        CAPTURE(width, u, v);
        const std::int16_t* p = image.pixel(u, v);
        CHECK(p[0] == level.row(v)[u]);
        CHECK(p[3] == 0);
        if (u == 0 || u == level.width - 1) {
          CHECK(p[1] == 0);
          CHECK(p[2] == 0);
          continue;
        }
        CHECK(p[1] == level.row(v)[u + 1] - level.row(v)[u - 1]);
        if (v > 0 && v < level.height - 1) CHECK(p[2] == level.row(v + 1)[u] - level.row(v - 1)[u]);
      }
    }
  }
}

TEST_CASE("a smaller image after a larger one leaves nothing behind") {
  GradientImage image;
  image.build(test::levelOf(80, 40, [](int u, int) { return 3 * u; }));
  image.build(test::levelOf(40, 20, [](int, int) { return 9; }));
  CHECK(image.width() == 40);
  CHECK(image.height() == 20);
  for (int v = 0; v < 20; ++v) {
    for (int u = 0; u < 40; ++u) CHECK(image.gradientSquared(u, v) == 0);
  }
}
