// SPDX-License-Identifier: BSD-3-Clause
// True cameras beside their calibration.
#include "camera.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "small_town.hpp"

using namespace tolman;
using namespace tolman::town;
using tolman::town::test::SmallTown;

TEST_CASE("no error, no warp") { CHECK(makeWarp(100, 50, 0, 1).isEmpty()); }

TEST_CASE("a warp has the wanted rms, no mean, and is smooth") {
  constexpr int kWidth = 200;
  constexpr int kHeight = 60;
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const PixelWarp warp = makeWarp(kWidth, kHeight, 0.7, seed);
    REQUIRE(warp.x.size() == kWidth * kHeight);
    REQUIRE(warp.y.size() == kWidth * kHeight);
    double squares = 0;
    double mean = 0;
    double steepest = 0;
    for (std::size_t i = 0; i < warp.x.size(); ++i) {
      const auto x = static_cast<double>(warp.x[i]);
      const auto y = static_cast<double>(warp.y[i]);
      squares += (x * x + y * y) / (kWidth * kHeight);
      mean += x / (kWidth * kHeight);
      if (i % kWidth == 0) continue;
      steepest = std::max(steepest, std::abs(x - static_cast<double>(warp.x[i - 1])));
    }
    CHECK(std::sqrt(squares) == Approx(0.7).epsilon(1e-4));
    CHECK(std::abs(mean) < 1e-4);
    CHECK(steepest < 0.7 * 10 * 3.2 / kWidth);  // three half periods over the width
  }
}

TEST_CASE("a constant warp renders what a moved principal point renders") {
  const SmallTown town;
  RenderCamera moved = SmallTown::view(town.route.T_town_camera[40]);
  RenderCamera warped = moved;
  moved.pinhole.cx -= 3;
  moved.pinhole.cy += 2;
  const auto pixels = static_cast<std::size_t>(moved.width * moved.height);
  const PixelWarp warp = {std::vector<float>(pixels, 3), std::vector<float>(pixels, -2)};
  warped.warp = &warp;
  const RenderedImage a = town.picture(moved);
  const RenderedImage b = town.picture(warped);
  std::size_t same = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    same += std::abs(a.radiance[i] - b.radiance[i]) < 0.01F &&
            std::abs(a.depth[i] - b.depth[i]) < 0.01F * a.depth[i] + 0.01F;
  }
  CHECK(static_cast<double>(same) > 0.99 * static_cast<double>(pixels));
}

namespace {

CameraRig halfSize() {
  CameraRig rig;
  rig.width = 620;
  rig.height = 188;
  rig.pinhole = {359.4, 359.4, 303.3, 92.4};
  rig.baseline = 0.5372;
  rig.calibrated = true;
  return rig;
}

}  // namespace

TEST_CASE("without errors the cameras are what the calibration says") {
  const auto cameras = trueCameras({}, halfSize());
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
  parameters.rig_error = {0.01, -0.02};
  parameters.camera_error = 2;
  const auto cameras = trueCameras(parameters, halfSize());
  CHECK(cameras[0].pinhole.fx == Approx(1.01 * 359.4));
  CHECK(cameras[1].pinhole.fy == Approx(1.01 * 359.4));
  CHECK(cameras[0].pinhole.cx == Approx(303.3 + 0.2));
  CHECK(cameras[0].pinhole.cy == Approx(92.4 - 0.2));
  CHECK(cameras[1].pinhole.cy == Approx(92.4 + 0.2));
  CHECK(cameras[1].T_left_camera.translation().x() == Approx(0.98 * 0.5372));
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
  const auto axisOf = [&](std::vector<double> error, const Eigen::Vector3d& of) -> Eigen::Vector3d {
    TownParameters parameters;
    parameters.rig_error = std::move(error);
    return trueCameras(parameters, halfSize())[1].T_left_camera.linear() * of;
  };
  const Eigen::Vector3d ahead = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d right = Eigen::Vector3d::UnitX();
  CHECK(axisOf({0, 0, small}, ahead).isApprox(Eigen::Vector3d(1e-3, 0, 1), 1e-5));
  CHECK(axisOf({0, 0, 0, small}, ahead).isApprox(Eigen::Vector3d(0, -1e-3, 1), 1e-5));
  CHECK(axisOf({0, 0, 0, 0, small}, right).isApprox(Eigen::Vector3d(1, 1e-3, 0), 1e-5));
}
