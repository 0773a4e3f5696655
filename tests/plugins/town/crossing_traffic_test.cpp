// SPDX-License-Identifier: BSD-3-Clause
// Cars of side streets: they approach, wait while the camera passes, and cross.
#include "crossing_traffic.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "drawn_route.hpp"
#include "place_of.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

/// Round a block and over its own start at a right angle; the camera drives 10 m/s.
const CameraRoute kCrossedRoute = town::test::drawnRoute(LanePath(StreetPlan::kLaneOffset)
                                                             .ahead(100)
                                                             .turnRight(7)
                                                             .ahead(60)
                                                             .turnRight(7)
                                                             .ahead(60)
                                                             .turnRight(7)
                                                             .ahead(120));

struct Watched {
  double longest_wait = 0;                                   // s
  double waits_from = 0;                                     // s
  double path = 0;                                           // m
  double nearest = std::numeric_limits<double>::infinity();  // m to the camera
};

Watched watch(const CrossingTraffic& traffic, std::size_t car) {
  constexpr double kStep = 0.1;
  Watched seen;
  double since = 0;
  for (std::size_t i = 0; i + 1 < kCrossedRoute.T_town_camera.size(); ++i) {
    const double t = static_cast<double>(i) * kStep;
    const auto now = traffic.at(car, t);
    const auto next = traffic.at(car, t + kStep);
    if (!now || !next) continue;
    const Eigen::Vector2d camera = kCrossedRoute.T_town_camera[i].translation().head<2>();
    seen.nearest = std::min(seen.nearest, (tolman::town::test::placeOf(*now) - camera).norm());
    const double step =
        (tolman::town::test::placeOf(*next) - tolman::town::test::placeOf(*now)).norm();
    REQUIRE(step < 7.5 * kStep);  // never faster, and it does not jump
    seen.path += step;
    since = step < 1e-3 ? since + kStep : 0;
    if (since > seen.longest_wait) {
      seen.longest_wait = since;
      seen.waits_from = t - since;
    }
  }
  return seen;
}

}  // namespace

TEST_CASE("at a crossing cars wait in side streets until the camera has passed") {
  const StreetPlan plan = StreetPlan::grow(kCrossedRoute, 1.65).value();
  const CrossingTraffic traffic(kCrossedRoute, plan, 1, 6);
  // Two arms when the first street is driven, two when the second crosses it.
  REQUIRE(traffic.size() >= 3);
  REQUIRE(traffic.size() <= 4);
  for (std::size_t i = 0; i < traffic.size(); ++i) {
    const Watched seen = watch(traffic, i);
    CAPTURE(i);
    CHECK(seen.longest_wait > 3);
    CHECK(seen.path > 40);
    CHECK(seen.nearest > 3.3);  // middle of the car to the camera, on the lane beside it
  }
  CHECK_FALSE(traffic.at(0, -1000));
  CHECK_FALSE(traffic.at(0, 1000));
}

TEST_CASE("a share of the side streets has cars, and a street without crossings none") {
  const StreetPlan plan = StreetPlan::grow(kCrossedRoute, 1.65).value();
  CHECK(CrossingTraffic(kCrossedRoute, plan, 0, 6).size() == 0);
  const CameraRoute straight = town::test::drawnRoute(LanePath(0).ahead(300));
  const StreetPlan street = StreetPlan::grow(straight, 1.65).value();
  CHECK(CrossingTraffic(straight, street, 1, 6).size() == 0);
  const CameraRoute district = town::test::builtIn("district");
  const StreetPlan districts = StreetPlan::grow(district, 1.65).value();
  const std::size_t all = CrossingTraffic(district, districts, 1, 6).size();
  const std::size_t some = CrossingTraffic(district, districts, 0.5, 6).size();
  CHECK(all >= 4);
  CHECK(some < all);
}
