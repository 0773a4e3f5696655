// SPDX-License-Identifier: BSD-3-Clause
// Lanes beside a route: their offset, direction, length and the frames that they lie beside.
#include "lane.hpp"

#include <catch2/catch.hpp>

#include "drawn_route.hpp"

using namespace tolman;
using namespace tolman::town;

TEST_CASE("a lane beside a straight street is parallel to it") {
  LanePath path(0);
  path.ahead(100);
  const CameraRoute route = town::test::drawnRoute(path);
  for (const double left : {3.4, -1.2, 0.0}) {
    const Lane lane(route, left);
    REQUIRE_FALSE(lane.isEmpty());
    CHECK(lane.length() == Approx(100));
    for (const double s : {0.0, 0.4, 33.3, 100.0}) {
      const Lane::Position place = lane.at(s);
      CHECK(place.position.x() == Approx(-left).margin(1e-9));
      CHECK(place.position.y() == Approx(s).margin(1e-9));
      CHECK(place.along.normalized().y() == Approx(1));
    }
    CHECK(lane.frameAt(50) == 50);
  }
}

TEST_CASE("in a bend the outer lane is longer by its offset times the angle") {
  LanePath path(0);
  path.ahead(20).curve(30, 1.5).ahead(20);
  const CameraRoute route = town::test::drawnRoute(path);
  const double middle = Lane(route, 0).length();
  CHECK(Lane(route, -4).length() - middle == Approx(4 * 1.5).margin(0.6));  // ends on whole metres
  CHECK(middle - Lane(route, 4).length() == Approx(4 * 1.5).margin(1.2));
}

TEST_CASE("a route that stands still has no lane") {
  CameraRoute route = town::test::drawnRoute(LanePath(0).ahead(5));
  route.T_town_camera.resize(1);
  CHECK(Lane(route, 1).isEmpty());
  CHECK(Lane().length() == 0);
}
