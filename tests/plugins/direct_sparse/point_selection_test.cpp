// SPDX-License-Identifier: BSD-3-Clause
// Number, places and gradients of selected points.
#include "point_selection.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

GrayLevel street() { return test::streetPyramid(test::streetPose(0)).level(0); }

}  // namespace

TEST_CASE("about as many as wanted, each once, away from the border") {
  const GrayLevel image = street();
  for (const int wanted : {200, 600, 1500}) {
    PointSelector selector;
    selector.select(image, wanted, 5);
    const std::vector<Pixel> pixels = selector.select(image, wanted, 5);  // the count has settled
    CAPTURE(wanted, pixels.size());
    CHECK(static_cast<int>(pixels.size()) > wanted / 2);
    CHECK(static_cast<int>(pixels.size()) < 2 * wanted);
    std::set<std::pair<int, int>> different;
    for (const Pixel& p : pixels) {
      different.insert({p.u, p.v});
      CHECK(p.u >= 5);
      CHECK(p.v >= 5);
      CHECK(p.u < image.width - 5);
      CHECK(p.v < image.height - 5);
    }
    CHECK(different.size() == pixels.size());
  }
}

TEST_CASE("points are spread over the image") {
  PointSelector selector;
  int quarters[4] = {};
  const auto& pixels = selector.select(street(), 600, 5);
  for (const Pixel& p : pixels) ++quarters[(p.u < 240 ? 0 : 1) + (p.v < 100 ? 0 : 2)];
  for (const int count : quarters) CHECK(count > static_cast<int>(pixels.size()) / 10);
}

TEST_CASE("a constant image has none, nor has one whose texture is all below the threshold") {
  PointSelector selector;
  CHECK(selector.select(test::levelOf(320, 160, [](int, int) { return 90; }), 500, 5).empty());
  const auto ripple = [](int u, int v) { return 100 + 2 * ((u + v) % 2); };
  CHECK(selector.select(test::levelOf(320, 160, ripple), 500, 5).empty());
}

TEST_CASE("the threshold is that of the neighbourhood: weak texture counts where all is weak") {
  // Strong texture on the left, weak on the right; a global threshold would take the left alone.
  const auto value = [](int u, int v) {
    const int strength = u < 160 ? 60 : 16;
    return 120 + (u / 5 + v / 5) % 2 * strength;
  };
  PointSelector selector;
  int left = 0;
  int right = 0;
  for (const Pixel& p : selector.select(test::levelOf(320, 160, value), 400, 5)) {
    ++(p.u < 160 ? left : right);
  }
  CHECK(left > 50);
  CHECK(right > 20);
}

TEST_CASE("a selector that was reset answers like a fresh one") {
  const GrayLevel image = street();
  PointSelector used;
  used.select(image, 100, 5);
  used.reset();
  PointSelector fresh;
  const auto& a = used.select(image, 700, 5);
  const auto& b = fresh.select(image, 700, 5);
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].u == b[i].u);
    CHECK(a[i].v == b[i].v);
  }
}
