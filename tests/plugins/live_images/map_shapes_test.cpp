// SPDX-License-Identifier: BSD-3-Clause
#include "map_shapes.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace tolman::ros_map {
namespace {

/// A camera at (right, down, forward) that has turned to the left by `angle`.
Eigen::Isometry3d cameraAt(double right, double down, double forward, double angle) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = Eigen::Vector3d(right, down, forward);
  T.linear() = Eigen::AngleAxisd(-angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
  return T;
}

Eigen::Vector3d turned(const RosPose& pose, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(pose.qw, pose.qx, pose.qy, pose.qz) * axis;
}

}  // namespace

TEST_CASE("forward is x, left is y, up is z") {
  const RosPose pose = robotPose(cameraAt(1, 2, 3, 0));
  CHECK(pose.position.x == 3);
  CHECK(pose.position.y == -1);
  CHECK(pose.position.z == -2);
  CHECK(pose.qw == Approx(1));
}

TEST_CASE("a turn to the left is one about z, counter-clockwise") {
  const RosPose pose = robotPose(cameraAt(0, 0, 0, M_PI / 2));
  CHECK((turned(pose, Eigen::Vector3d::UnitX()) - Eigen::Vector3d::UnitY()).norm() < 1e-12);
  CHECK(pose.qz == Approx(std::sqrt(0.5)));
}

TEST_CASE("the optical axis of the camera's own frame is its z") {
  const RosPose straight = cameraPose(cameraAt(0, 0, 0, 0));
  CHECK((turned(straight, Eigen::Vector3d::UnitZ()) - Eigen::Vector3d::UnitX()).norm() < 1e-12);
  CHECK((turned(straight, Eigen::Vector3d::UnitY()) + Eigen::Vector3d::UnitZ()).norm() < 1e-12);
  const RosPose left = cameraPose(cameraAt(0, 0, 0, M_PI / 2));
  CHECK((turned(left, Eigen::Vector3d::UnitZ()) - Eigen::Vector3d::UnitY()).norm() < 1e-12);
}

TEST_CASE("a map as a path and lines; rejected loops are left out") {
  MapGraph graph;
  for (int i = 0; i < 3; ++i) {
    Experience experience;
    experience.id = i;
    experience.T_world_experience = cameraAt(0, 0, i, 0);
    graph.experiences.push_back(experience);
  }
  const auto link = [&](std::int64_t from, std::int64_t to, LinkKind kind) {
    Link made;
    made.id = static_cast<std::int64_t>(graph.links.size());
    made.from = from;
    made.to = to;
    made.kind = kind;
    graph.links.push_back(made);
  };
  link(0, 1, LinkKind::Odometry);
  link(1, 2, LinkKind::Odometry);
  link(2, 0, LinkKind::Loop);
  link(2, 1, LinkKind::Loop);
  graph.rejected = {3};
  const MapShapes shapes = shapesOf(graph);
  REQUIRE(shapes.path.size() == 3);
  CHECK(shapes.path[2].position.x == 2);
  CHECK(shapes.odometry.size() == 4);
  REQUIRE(shapes.loops.size() == 2);
  CHECK(shapes.loops[0].x == 2);
  CHECK(shapes.loops[1].x == 0);
}

}  // namespace tolman::ros_map
