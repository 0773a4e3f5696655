// SPDX-License-Identifier: BSD-3-Clause
// Views: patches of mean 0 and deviation 1, whatever the light.
#include "patch_view.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/gray_images.hpp"

using namespace tolman;
using namespace tolman::seqslam;
using tolman::test::coloured;
using tolman::test::gray;
using tolman::test::noise;

TEST_CASE("every patch has mean 0 and standard deviation 1, and keeps the order of its pixels") {
  RandomStream random(1);
  const Image image = noise(64, 32, random);  // nothing to reduce
  const PatchView view = patchView(image, {});
  REQUIRE(view.size() == 64 * 32);
  for (int y = 0; y < 32; y += 8) {
    for (int x = 0; x < 64; x += 8) {
      double sum = 0;
      double squares = 0;
      for (int i = 0; i < 64; ++i) {
        const double value = view[std::size_t((y + i / 8) * 64 + x + i % 8)] / double{kUnit};
        sum += value;
        squares += value * value;
      }
      CHECK(sum / 64 == Approx(0).margin(0.02));
      CHECK(squares / 64 == Approx(1).margin(0.03));
    }
  }
  for (std::size_t i = 1; i < 8; ++i) {
    CHECK((view[i] < view[0]) <= (image.row(0)[i] < image.row(0)[0]));
  }
}

TEST_CASE("another light on each patch changes nothing; another place does") {
  RandomStream random(2);
  const Image image = gray(64, 32, [&](int, int) { return 2 * random.below(50); });
  const Image lit = gray(64, 32, [&](int x, int y) {
    return image.row(y)[x] * (x < 32 ? 2 : 1) / (y < 16 ? 1 : 2) + x / 8 * 5;
  });
  const PatchView view = patchView(image, {});
  CHECK(differenceOf(view, patchView(lit, {})) == Approx(0).margin(1e-6));
  CHECK(differenceOf(view, patchView(noise(64, 32, random), {})) > 0.8);
}

TEST_CASE("images of any size and colour are reduced to the same view") {
  RandomStream random(3);
  const Image small = noise(64, 32, random);
  const Image large = gray(64 * 5, 32 * 3, [&](int x, int y) { return small.row(y / 3)[x / 5]; });
  CHECK(patchView(large, {}) == patchView(small, {}));
  CHECK(patchView(coloured(small), {}) == patchView(small, {}));
  CHECK(patchView(noise(7, 5, random), {}).size() == 64 * 32);
  CHECK(patchView(large, {32, 24, 4}).size() == 32 * 24);
}

TEST_CASE("patches at the edge are smaller, and each is normalised for itself") {
  RandomStream random(4);
  const Image image = noise(20, 10, random);
  const PatchView view = patchView(image, {20, 10, 8});
  for (const auto& [x0, y0, x1, y1] : {std::array{16, 0, 20, 8}, std::array{0, 8, 8, 10}}) {
    int sum = 0;
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) sum += view[std::size_t(y * 20 + x)];
    }
    CHECK(std::abs(sum) <= 8);  // rounding only
  }
}

TEST_CASE("patches without contrast are 0") {
  const Image half = gray(64, 32, [](int x, int y) { return x < 32 ? 90 : (x * y) % 251; });
  const PatchView view = patchView(half, {});
  for (std::size_t i = 0; i < view.size(); ++i) {
    if (i % 64 < 32) CHECK(view[i] == 0);
  }
  const PatchView black = patchView(gray(100, 50, [](int, int) { return 0; }), {});
  CHECK(black == PatchView(64 * 32, 0));
  // One bright pixel is the largest value that there can be.
  const Image spot = gray(64, 32, [](int x, int y) { return x == 3 && y == 3 ? 255 : 0; });
  CHECK(patchView(spot, {})[3 * 64 + 3] == std::lround(kUnit * std::sqrt(63.0)));
}

TEST_CASE("the difference is the mean absolute one") {
  const PatchView a = {15, -15, 0, 30};
  const PatchView b = {0, 15, 0, 15};
  CHECK(differenceOf(a, b) == Approx((1 + 2 + 0 + 1) / 4.0));
  const PatchView most(1024 * 1024, 127);
  const PatchView least(1024 * 1024, -127);
  CHECK(differenceOf(most, least) == Approx(254.0 / kUnit));
}
