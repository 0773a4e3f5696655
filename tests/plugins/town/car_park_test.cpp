// SPDX-License-Identifier: BSD-3-Clause
// The car park: the drive, floors and ramps that agree with the poses, and identical floors.
#include "car_park.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "drawn_route.hpp"
#include "probe.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

constexpr double kParkCamera = 1.65;

struct CarParkTown {
  CameraRoute route = town::test::builtIn("car_park", 3);
  StreetPlan plan = StreetPlan::grow(route, kParkCamera).value();
  World world = build();

  World build() const {
    World made = buildWorld(plan, {1, 0.15, 1, false, {carParkPlot()}});
    addCarPark(made, -kParkCamera, 7);
    return made;
  }
  bool holds(const Vec3& p) const {
    return p.x > -9.01F && p.x < 41.01F && p.y > 56 && p.y < 108.01F;
  }
};

}  // namespace

TEST_CASE("a ramp rises by a storey without a kink") {
  CHECK(CarPark::rampHeight(0) == 0);
  CHECK(CarPark::rampHeight(CarPark::kRampLength) == Approx(CarPark::kStorey));
  double steepest = 0;
  for (double t = 0.05; t < CarPark::kRampLength; t += 0.1) {
    const double slope = (CarPark::rampHeight(t + 1e-4) - CarPark::rampHeight(t - 1e-4)) / 2e-4;
    CHECK(CarPark::rampSlope(t) == Approx(slope).margin(1e-6));
    CHECK(CarPark::rampHeight(t) + CarPark::rampHeight(CarPark::kRampLength - t) ==
          Approx(CarPark::kStorey));
    steepest = std::max(steepest, slope);
  }
  CHECK(steepest < 0.15);
}

TEST_CASE("the drive climbs to the fifth floor and comes down, twice") {
  const CameraRoute route = town::test::builtIn("car_park");
  int tops = 0;
  bool was_top = false;
  double length = 0;
  for (std::size_t i = 0; i < route.T_town_camera.size(); ++i) {
    const double z = route.T_town_camera[i].translation().z();
    CHECK(z > -1e-9);
    CHECK(z < 12 + 1e-9);
    const bool is_top = z > 12 - 1e-6;
    tops += is_top && !was_top;
    was_top = is_top;
    if (i == 0) continue;
    const Eigen::Vector3d step =
        route.T_town_camera[i].translation() - route.T_town_camera[i - 1].translation();
    CHECK(step.norm() < 0.55);
    length += step.norm();
    // The camera looks where it goes, up and down, too.
    if (step.norm() > 0.1) {
      CHECK(step.normalized().dot(route.T_town_camera[i].linear().col(2)) > 0.98);
    }
  }
  CHECK(tops == 2);
  CHECK(length == Approx(2300).margin(250));
  CHECK(std::abs(route.T_town_camera.back().translation().z()) < 1e-9);
  CHECK_FALSE(route.isRaised(0));
  CHECK_FALSE(route.isRaised(route.T_town_camera.size() - 1));
}

TEST_CASE("floors and ramps lie below the cameras at their height, and nothing stands in the way") {
  const CarParkTown building;
  const Scene scene(building.world);
  for (std::size_t i = 0; i < building.route.T_town_camera.size(); ++i) {
    const Eigen::Isometry3d& T = building.route.T_town_camera[i];
    const Eigen::Vector3d camera = T.translation();
    CAPTURE(i, camera.transpose());
    REQUIRE(town::test::distanceTo(scene, camera, -Eigen::Vector3d::UnitZ()) ==
            Approx(kParkCamera).margin(0.03));
    for (const double side : {-1.0, 1.0}) {  // a car is 1.8 m wide
      const Eigen::Vector3d over = side * T.linear().col(0);
      REQUIRE(town::test::distanceTo(scene, camera - Eigen::Vector3d(0, 0, 1), over) > 0.95);
    }
    REQUIRE(town::test::distanceTo(scene, camera, T.linear().col(2)) > 2);
  }
}

TEST_CASE("all floors are alike: the same cars at the same places") {
  const CarParkTown building;
  std::vector<std::vector<std::array<float, 4>>> floors(CarPark::kFloors);
  for (const MeshInstance& car : building.world.instances) {
    const Vec3& p = car.placement.position;
    if (!building.holds(p)) continue;
    const double level = (static_cast<double>(p.z) + kParkCamera) / CarPark::kStorey;
    REQUIRE(level == Approx(std::round(level)).margin(1e-5));
    floors.at(static_cast<std::size_t>(std::lround(level)))
        .push_back({p.x, p.y, car.placement.cosine, static_cast<float>(car.prototype)});
  }
  CHECK(floors[0].size() > 15);
  for (const auto& floor : floors) CHECK(floor == floors[0]);
}

TEST_CASE("the ground is below the lowest floor, and no house stands in the building") {
  const CarParkTown building;
  for (double x = CarPark::kWest; x <= CarPark::kEast; x += 1.7) {
    for (double y = 56; y <= 108; y += 1.3) {
      REQUIRE(building.plan.height(x, y) + StreetPlan::kKerbHeight < -kParkCamera - 0.1);
    }
  }
  const World street = buildWorld(building.plan, {1, 0.15, 1, false, {carParkPlot()}});
  for (const MeshInstance& instance : street.instances) {
    CHECK_FALSE(building.holds(instance.placement.position));
  }
}
