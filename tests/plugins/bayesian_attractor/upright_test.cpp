// SPDX-License-Identifier: BSD-3-Clause
// The up direction of cameras in any orientation on a vehicle.
#include <catch2/catch.hpp>
#include <numbers>

#include "level_step.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;

namespace {

Eigen::Isometry3d turned(const Eigen::Vector3d& rotation) {
  Vector6d twist = Vector6d::Zero();
  twist.tail<3>() = rotation;
  return expSe3(twist);
}

/// Steps of a level vehicle (x right, y down, z forward) that turns by `yaw` rad each, seen by a
/// camera with rotation `R_vehicle_camera`.
Eigen::Isometry3d stepOf(double yaw, const Eigen::Isometry3d& T_vehicle_camera) {
  Vector6d twist = Vector6d::Zero();
  twist[2] = 1;
  twist[4] = yaw;
  return T_vehicle_camera.inverse() * expSe3(twist) * T_vehicle_camera;
}

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

TEST_CASE("a camera that looks down or up is found out with the first metres") {
  for (const double pitch : {-0.7, -0.1, 0.0, 0.3, 0.7}) {
    const Eigen::Isometry3d mount = turned({pitch, 0, 0});
    Upright upright;
    for (int k = 0; k < 3; ++k) upright.add(stepOf(0, mount));
    CHECK(angleBetween(upright.up(), mount.linear().transpose() * kLevelUp) < 1e-9);
  }
}

TEST_CASE("a camera in any attitude is found out when the vehicle has turned") {
  RandomStream random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Vector3d rotation =
        0.4 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
    const Eigen::Isometry3d mount = turned(rotation);
    if (mount.linear()(1, 1) < 0.3) continue;  // the camera is on its side or upside down
    Upright upright;
    for (int k = 0; k < 60; ++k) upright.add(stepOf(0.1, mount));
    CAPTURE(rotation.transpose());
    CHECK(angleBetween(upright.up(), mount.linear().transpose() * kLevelUp) < 1e-6);
  }
}

TEST_CASE("ramps up and down turn what is up, and not the mount") {
  const Eigen::Isometry3d mount = turned({0.5, 0, 0.3});
  Upright upright;
  Eigen::Matrix3d R_first_vehicle = Eigen::Matrix3d::Identity();
  const auto drive = [&](const Eigen::Vector3d& rotation) {
    Eigen::Isometry3d step = turned(rotation);
    step.translation().z() = 1;
    R_first_vehicle = R_first_vehicle * step.linear();
    upright.add(mount.inverse() * step * mount);
  };
  for (int round = 0; round < 4; ++round) {
    for (int k = 0; k < 40; ++k) drive({0, 0.1, 0});
    drive({0.15, 0, 0});
    for (int k = 0; k < 10; ++k) drive({0, 0, 0});
    drive({-0.15, 0, 0});
  }
  const Eigen::Vector3d level = (R_first_vehicle * mount.linear()).transpose() * kLevelUp;
  CHECK(angleBetween(upright.up(), level) < 0.02);
  drive({0.15, 0, 0});  // onto a ramp: up is where it was
  const Eigen::Vector3d on_ramp = (R_first_vehicle * mount.linear()).transpose() * kLevelUp;
  CHECK(angleBetween(upright.up(), on_ramp) < 0.02);
}

TEST_CASE("a camera in a hand has no axes of a vehicle: its first image is taken to be level") {
  RandomStream random(5);
  Upright upright;
  Eigen::Matrix3d R_first_camera = Eigen::Matrix3d::Identity();
  for (int k = 0; k < 500; ++k) {
    Vector6d twist;
    for (int i = 0; i < 6; ++i) twist[i] = 0.1 * random.normal();
    upright.add(expSe3(twist));
    R_first_camera = R_first_camera * expSe3(twist).linear();
  }
  CHECK(angleBetween(upright.up(), R_first_camera.transpose() * kLevelUp) < 1e-6);
}
