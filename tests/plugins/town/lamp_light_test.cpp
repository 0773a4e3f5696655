// SPDX-License-Identifier: BSD-3-Clause
// Light of lamps: dependence on distance and angle, and range.
#include "lamp_light.hpp"

#include <catch2/catch.hpp>

using namespace tolman::town;

namespace {
constexpr Vec3 kUp = {0, 0, 1};
}

TEST_CASE("below a lamp light falls off with the square of the height") {
  const StreetLamps low({{100, -50, 4}});
  const StreetLamps high({{100, -50, 8}});
  CHECK(low.onto({100, -50, 0}, kUp) == Approx(4 * high.onto({100, -50, 0}, kUp)));
  CHECK(low.onto({100, -50, 0}, {0, 0, -1}) == 0);
  CHECK(low.onto({110, -50, 0}, kUp) < low.onto({105, -50, 0}, kUp));
  CHECK(low.onto({131, -50, 0}, kUp) == 0);
}

TEST_CASE("lamps add up, also across cells, and shine themselves") {
  std::vector<Vec3> heads;
  float sum = 0;
  const Vec3 point = {0.5F, 0.5F, 0};
  for (int i = 0; i < 8; ++i) {
    heads.push_back({static_cast<float>(i * 9 - 36), static_cast<float>(i % 3 * 8 - 8), 5});
    sum += StreetLamps({heads.back()}).onto(point, kUp);
  }
  const StreetLamps lamps(heads);
  CHECK(lamps.onto(point, kUp) == Approx(sum));
  CHECK(lamps.isHead(heads[3]));
  CHECK_FALSE(lamps.isHead({heads[3].x, heads[3].y, 4}));
  CHECK(StreetLamps().onto(point, kUp) == 0);
  CHECK_FALSE(StreetLamps().isHead(point));
}

TEST_CASE("low beams light what is ahead, below the horizon, and faces the car") {
  const Headlights beams = {{0, 0, 0.7F}, {0, 1, 0}};
  const Vec3 to_car = {0, -1, 0};
  const float ahead = headlightsOnto(beams, {0, 15, 0.3F}, to_car);
  CHECK(ahead > 0.1F);
  CHECK(headlightsOnto(beams, {0, 30, 0.3F}, to_car) < ahead);
  CHECK(headlightsOnto(beams, {0, 15, 3}, to_car) < 0.2F * ahead);
  CHECK(headlightsOnto(beams, {12, 15, 0.3F}, to_car) < 0.3F * ahead);
  CHECK(headlightsOnto(beams, {12, 15, 0.3F}, to_car) ==
        Approx(headlightsOnto(beams, {-12, 15, 0.3F}, to_car)));
  CHECK(headlightsOnto(beams, {0, -15, 0.3F}, {0, 1, 0}) == 0);
  CHECK(headlightsOnto(beams, {0, 15, 0.3F}, {0, 1, 0}) == 0);
}
