// SPDX-License-Identifier: BSD-3-Clause
// True cameras, from the errors of the calibration.
#include "true_camera.hpp"

#include <catch2/catch.hpp>
#include <numbers>

using namespace tolman;
using namespace tolman::town;

namespace {

CameraRig halfSize() {
  CameraRig rig;
  rig.width = 620;
  rig.height = 188;
  rig.pinhole = {359.4, 359.4, 303.3, 92.4};
  rig.baseline = 0.5372;
  return rig;
}

std::string refusal(const TownParameters& parameters) {
  const auto cameras = trueCameras(parameters, halfSize());
  REQUIRE_FALSE(cameras.isOk());
  return std::string(cameras.status().message());
}

}  // namespace

TEST_CASE("without errors the cameras are what the calibration says") {
  const auto cameras = trueCameras({}, halfSize()).value();
  for (const TrueCamera& camera : cameras) {
    CHECK(camera.pinhole.fx == 359.4);
    CHECK(camera.pinhole.cy == 92.4);
    CHECK(camera.warp.isEmpty());
  }
  CHECK(cameras[0].T_left_camera.isApprox(Eigen::Isometry3d::Identity(), 0));
  CHECK(cameras[1].T_left_camera.translation() == Eigen::Vector3d(0.5372, 0, 0));
  CHECK(cameras[1].T_left_camera.linear() == Eigen::Matrix3d::Identity());
}

TEST_CASE("errors in px are those of the full size") {
  TownParameters parameters;
  parameters.scale = 0.5;
  parameters.focal_length_error = {0.01, -0.02};
  parameters.principal_point_error_px = {1, -2, 3, 4};
  parameters.warp_rms_px = 0.6;
  const auto cameras = trueCameras(parameters, halfSize()).value();
  CHECK(cameras[0].pinhole.fx == Approx(1.01 * 359.4));
  CHECK(cameras[1].pinhole.fy == Approx(0.98 * 359.4));
  CHECK(cameras[0].pinhole.cx == Approx(303.3 + 0.5));
  CHECK(cameras[0].pinhole.cy == Approx(92.4 - 1));
  CHECK(cameras[1].pinhole.cx == Approx(303.3 + 1.5));
  CHECK(cameras[1].pinhole.cy == Approx(92.4 + 2));
  double squares = 0;
  for (std::size_t i = 0; i < cameras[0].warp.x.size(); ++i) {
    squares += static_cast<double>(cameras[0].warp.x[i] * cameras[0].warp.x[i] +
                                   cameras[0].warp.y[i] * cameras[0].warp.y[i]);
  }
  CHECK(std::sqrt(squares / static_cast<double>(cameras[0].warp.x.size())) ==
        Approx(0.3).epsilon(1e-3));
  CHECK(cameras[0].warp.x != cameras[1].warp.x);
}

TEST_CASE("yaw turns the right camera to the right, pitch up, roll clockwise") {
  const double small = 1e-3 * 180 / std::numbers::pi;  // deg
  const auto axisOf = [&](std::vector<double> turn, const Eigen::Vector3d& of) -> Eigen::Vector3d {
    TownParameters parameters;
    parameters.right_rotation_error_deg = std::move(turn);
    const auto cameras = trueCameras(parameters, halfSize()).value();
    return cameras[1].T_left_camera.linear() * of;
  };
  const Eigen::Vector3d ahead = Eigen::Vector3d::UnitZ();
  CHECK(axisOf({small, 0, 0}, ahead).isApprox(Eigen::Vector3d(1e-3, 0, 1), 1e-5));
  CHECK(axisOf({0, small, 0}, ahead).isApprox(Eigen::Vector3d(0, -1e-3, 1), 1e-5));
  CHECK(
      axisOf({0, 0, small}, Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d(1, 1e-3, 0), 1e-5));
}

TEST_CASE("lists of a wrong length are refused with what they hold") {
  TownParameters parameters;
  parameters.gain = {1};
  CHECK(refusal(parameters) == "gain has 1 values; give 2: [left, right]");
  parameters = {};
  parameters.principal_point_error_px = {1, 2};
  CHECK(refusal(parameters) ==
        "principal_point_error_px has 2 values; give 4: [left x, left y, right x, right y]");
  parameters = {};
  parameters.right_rotation_error_deg = {};
  CHECK(refusal(parameters).find("yaw, pitch, roll") != std::string::npos);
}
