// SPDX-License-Identifier: BSD-3-Clause
// Paths of pixels, compared with projections of single points.
#include "pixel_paths.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tolman/geometry.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

RenderCamera cameraAt(const Eigen::Isometry3d& T_town_camera) {
  RenderCamera view;
  view.T_town_camera = T_town_camera;
  view.width = 40;
  view.height = 20;
  view.pinhole = {100, 110, 18, 9};
  return view;
}

/// Depth grows along rows; every third column belongs to instance 7, the last row is sky.
RenderedImage slope(const RenderCamera& view) {
  RenderedImage picture;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      picture.depth.push_back(row + 1 == view.height ? 0 : 4 + 0.5F * static_cast<float>(column));
      picture.instance.push_back(column % 3 == 0 ? 7 : column % 3 == 1 ? 2 : kNoInstance);
      picture.radiance.push_back(0);
    }
  }
  return picture;
}

ShutterMotion motionOf(const Vector6d& twist) {
  return {expSe3(0.5 * twist), expSe3(-0.5 * twist)};
}

Eigen::Vector2d projected(const Pinhole& k, const Eigen::Vector3d& p) {
  return {k.fx * p.x() / p.z() + k.cx, k.fy * p.y() / p.z() + k.cy};
}

}  // namespace

TEST_CASE("paths are those of projected points, of the fixed town and of objects") {
  const Eigen::Isometry3d T_town_camera =
      Eigen::Translation3d(3, -2, 1) *
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  const RenderCamera view = cameraAt(T_town_camera);
  const RenderedImage picture = slope(view);
  const OpenShutter shutter = {motionOf((Vector6d() << 0.02, 0, 0.3, 0, 0.02, 0.01).finished()),
                               {{}, motionOf((Vector6d() << 0.2, 0.1, 0, 0, 0, 0.1).finished())},
                               6};
  const PixelPaths paths = pixelPaths(view, picture, shutter);
  for (const auto& [column, row] : {std::pair{0, 0}, {3, 5}, {4, 5}, {5, 5}, {39, 18}, {10, 19}}) {
    CAPTURE(column, row);
    const auto i = static_cast<std::size_t>(row * view.width + column);
    const double z = row == 19 ? 1e4 : static_cast<double>(picture.depth[i]);
    const Eigen::Vector3d point((column - 18.0) / 100 * z, (row - 9.0) / 110 * z, z);
    const ShutterMotion object = column % 3 == 0 ? shutter.objects[1] : ShutterMotion{};
    const auto seen = [&](const Eigen::Isometry3d& camera, const Eigen::Isometry3d& town) {
      return projected(view.pinhole,
                       camera * (T_town_camera.inverse() * (town * (T_town_camera * point))));
    };
    const Eigen::Vector2d way = seen(shutter.camera.T_end_middle, object.T_end_middle) -
                                seen(shutter.camera.T_begin_middle, object.T_begin_middle);
    CHECK(static_cast<double>(paths.u[i]) == Approx(way.x()).margin(0.02));
    CHECK(static_cast<double>(paths.v[i]) == Approx(way.y()).margin(0.02));
  }
}

TEST_CASE("paths are bounded, and none where a surface passes the camera") {
  const RenderCamera view = cameraAt(Eigen::Isometry3d::Identity());
  RenderedImage picture = slope(view);
  picture.depth[0] = 0.2F;
  const Eigen::Isometry3d half(Eigen::Translation3d(0, 0, 1));
  const PixelPaths ahead = pixelPaths(view, picture, {{half, half.inverse()}, {}, 0});
  CHECK(ahead.at(0).square() == 0);
  CHECK(ahead.at(5).square() > 1);
  const Eigen::Isometry3d aside(Eigen::Translation3d(-9, 0, 0));
  const PixelPaths swift = pixelPaths(view, picture, {{aside.inverse(), aside}, {}, 0});
  CHECK(static_cast<double>(swift.u[1]) == Approx(-static_cast<double>(kLongestPath)));
}
