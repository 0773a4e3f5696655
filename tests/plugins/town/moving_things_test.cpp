// SPDX-License-Identifier: BSD-3-Clause
// Motions of vehicles and people while a shutter is open, compared with their places in the scene.
#include "moving_things.hpp"

#include <catch2/catch.hpp>

#include "small_town.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

/// A point 1 m ahead of the middle of an instance, m.
Eigen::Vector3d aheadOf(const Scene& scene, std::uint32_t instance) {
  const Placement& p = scene.ownerOf(instance, 0).instance->placement;
  const Vec3 ahead = p.position + p.rotate({1, 0, 0});
  return Eigen::Vector3f(ahead.x, ahead.y, ahead.z).cast<double>();
}

}  // namespace

TEST_CASE("objects move while the shutter is open as they do from one frame to another") {
  const CameraRoute route = builtInRoute("block", {}).value();
  const StreetPlan plan = StreetPlan::grow(route, RouteOptions{}.camera_height).value();
  TownParameters parameters;
  parameters.traffic = 20;
  parameters.cyclists = 20;
  parameters.pedestrians = 40;
  World world = buildWorld(plan, {});
  const auto fixed = static_cast<std::uint32_t>(world.instances.size());
  MovingThings things(parameters, route, plan, world);
  Scene scene(std::move(world));
  const auto at = [&](double seconds) {
    return MovingThings::Instant{seconds, route.T_town_camera[60]};
  };
  CHECK(things.arrange(scene, at(6)));
  OpenShutter shutter;
  things.follow(at(5.95), at(6.05), shutter);
  REQUIRE(shutter.first_object == fixed);
  REQUIRE(shutter.objects.size() > 20);
  std::vector<Eigen::Vector3d> middle;
  for (std::uint32_t i = 0; i < shutter.objects.size(); ++i) {
    middle.push_back(aheadOf(scene, fixed + i));
  }
  int moved = 0;
  things.arrange(scene, at(6.05));
  for (std::uint32_t i = 0; i < shutter.objects.size(); ++i) {
    const Eigen::Vector3d end = aheadOf(scene, fixed + i);
    CHECK((shutter.objects[i].T_end_middle * middle[i] - end).norm() < 1e-3);
    moved += (end - middle[i]).norm() > 0.03;
  }
  CHECK(moved > 20);
  things.arrange(scene, at(5.95));
  for (std::uint32_t i = 0; i < shutter.objects.size(); ++i) {
    CHECK((shutter.objects[i].T_begin_middle * middle[i] - aheadOf(scene, fixed + i)).norm() <
          1e-3);
  }
}
