// SPDX-License-Identifier: BSD-3-Clause
// People over time: on the pavement, at walking speed, up and down with a wait at both ends.
#include "pedestrians.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "drawn_route.hpp"
#include "place_of.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

struct Street {
  CameraRoute route = town::test::builtIn("district");
  StreetPlan plan = StreetPlan::grow(route, 1.65).value();
  Pedestrians people(double per_km, std::uint32_t seed = 4) const {
    return {pavementRuns(plan, {}), plan, per_km, seed};
  }
  double length() const {
    double sum = 0;
    for (const StreetSection& section : plan.sections()) sum += section.points.back().s;
    return sum;
  }
};

}  // namespace

TEST_CASE("there are as many people as asked for, and others for another seed") {
  const Street street;
  const Pedestrians people = street.people(50);
  CHECK(static_cast<double>(people.size()) == Approx(50 * street.length() / 1000).margin(0.51));
  CHECK(street.people(0).size() == 0);
  const Pedestrians again = street.people(50);
  const Pedestrians other = street.people(50, 5);
  std::size_t same = 0;
  for (std::size_t i = 0; i < people.size(); ++i) {
    CHECK(tolman::town::test::placeOf(people.at(i, 7).placement) ==
          tolman::town::test::placeOf(again.at(i, 7).placement));
    same += tolman::town::test::placeOf(people.at(i, 7).placement) ==
            tolman::town::test::placeOf(other.at(i, 7).placement);
  }
  CHECK(same == 0);
}

TEST_CASE("people walk at walking speed and face where they go; those who wait face the road") {
  const Street street;
  const Pedestrians people = street.people(40);
  int walking = 0;
  int waiting = 0;
  for (std::size_t i = 0; i < people.size(); ++i) {
    for (double t = 0; t < 200; t += 3.7) {
      const Pedestrians::Posture now = people.at(i, t);
      const Pedestrians::Posture soon = people.at(i, t + 0.05);
      const Eigen::Vector2d step =
          tolman::town::test::placeOf(soon.placement) - tolman::town::test::placeOf(now.placement);
      const Eigen::Vector2d facing(static_cast<double>(now.placement.cosine),
                                   static_cast<double>(now.placement.sine));
      CAPTURE(i, t);
      REQUIRE(step.norm() < 0.05 * 1.6 + 1e-3);
      if (now.phase == kStanding && soon.phase == kStanding) {
        REQUIRE(step.norm() < 1e-4);
        const Eigen::Vector2d ahead = tolman::town::test::placeOf(now.placement) + facing;
        const Eigen::Vector2d here = tolman::town::test::placeOf(now.placement);
        CHECK(street.plan.distance(ahead.x(), ahead.y()) <
              street.plan.distance(here.x(), here.y()));
        ++waiting;
      } else if (now.phase != kStanding && soon.phase != kStanding && step.norm() > 0.02) {
        REQUIRE(step.normalized().dot(facing) > 0.9);
        ++walking;
      }
    }
  }
  CHECK(walking > 100);
  CHECK(waiting > 50);
}

TEST_CASE("people stand on the pavement's height and never on a road") {
  const Street street;
  const Pedestrians people = street.people(60);
  for (std::size_t i = 0; i < people.size(); ++i) {
    for (double t = -50; t < 500; t += 41) {
      const Placement p = people.at(i, t).placement;
      const Eigen::Vector2d at = tolman::town::test::placeOf(p);
      REQUIRE(street.plan.distance(at.x(), at.y()) > StreetPlan::kRoadHalfWidth + 0.3);
      REQUIRE(static_cast<double>(p.position.z) ==
              Approx(street.plan.height(at.x(), at.y()) + StreetPlan::kKerbHeight).margin(1e-4));
      REQUIRE(p.scale > 0.6F);
      REQUIRE(p.scale < 1.1F);
    }
  }
}

TEST_CASE("a stride takes all postures in their order") {
  const Street street;
  const Pedestrians people = street.people(40);
  for (std::size_t i = 0; i < people.size(); ++i) {
    std::set<int> seen;
    bool stands = false;
    for (double t = 100; t < 103; t += 0.01) {
      const int now = people.at(i, t).phase;
      const int next = people.at(i, t + 0.01).phase;
      stands = stands || now == kStanding || next == kStanding;
      if (stands) break;
      seen.insert(now);
      const bool turned =
          tolman::town::test::placeOf(people.at(i, t).placement)
              .isApprox(tolman::town::test::placeOf(people.at(i, t + 0.01).placement), 1e-9);
      if (!turned) REQUIRE((next == now || next == (now + 1) % kGaitPhases));
    }
    if (!stands) CHECK(seen.size() == kGaitPhases);
  }
}
