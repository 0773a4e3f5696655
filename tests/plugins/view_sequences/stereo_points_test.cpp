// SPDX-License-Identifier: BSD-3-Clause
// Points of stereo pairs whose depth is known, and pairs that have none.
#include <catch2/catch.hpp>
#include <cmath>

#include "street_points.hpp"
#include "support/gray_images.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::view_sequences;

namespace {

CameraRig rigOf(int width, int height, double focal, double baseline) {
  CameraRig rig;
  rig.width = width;
  rig.height = height;
  rig.calibrated = true;
  rig.pinhole = {focal, focal, 0.5 * width - 0.5, 0.5 * height - 0.5};
  rig.baseline = baseline;
  return rig;
}

/// Squares of random grey on a wall across the view, whose disparity is `disparity` px.
Frame wall(const CameraRig& rig, int disparity, int square) {
  const auto image = [&](int moved) {
    return tolman::test::gray(rig.width, rig.height, [&](int x, int y) {
      RandomStream random(
          static_cast<std::uint64_t>((x + moved + 1000) / square * 4001 + y / square));
      return std::lround(random.uniform(20, 230));
    });
  };
  Frame frame;
  frame.left = image(0);
  frame.right = image(disparity);
  return frame;
}

void checkWall(const CameraRig& rig, int disparity, int square) {
  const StereoPoints stereo(rig);
  REQUIRE(stereo.canMeasure());
  const double depth = rig.pinhole.fx * rig.baseline / disparity;
  const auto points = stereo.pointsOf(wall(rig, disparity, square));
  CAPTURE(rig.width, depth, points.size());
  REQUIRE(points.size() > 300);
  std::size_t near = 0;
  double least = 0;
  double most = 0;
  for (const CentimetrePoint& p : points) {
    near += std::abs(0.01 * p.z() - depth) < 0.1 * depth ? 1U : 0U;
    least = std::min(least, 0.01 * p.x());
    most = std::max(most, 0.01 * p.x());
  }
  CHECK(static_cast<double>(near) > 0.97 * static_cast<double>(points.size()));
  // From one side of the view to the other, but not where only one camera sees the wall.
  const double half = 0.5 * rig.width / rig.pinhole.fx * depth;
  CHECK(most == Approx(half).epsilon(0.1));
  CHECK(least < 0);
  CHECK(least > -half);
}

}  // namespace

TEST_CASE("points lie at the depth of the disparity") {
  const CameraRig rig = rigOf(480, 160, 240, 0.5);
  checkWall(rig, 8, 3);   // 15 m
  checkWall(rig, 20, 3);  // 6 m
}

TEST_CASE("images that are wider than 640 px are halved, and the points stay where they are") {
  checkWall(rigOf(1242, 376, 718, 0.54), 48, 6);  // 8.1 m
  checkWall(rigOf(1300, 400, 700, 0.5), 20, 8);   // 17.5 m, a quarter of the size
}

TEST_CASE("what is too far gives no points") {
  const CameraRig rig = rigOf(480, 160, 240, 0.5);
  const StereoPoints stereo(rig);
  CHECK(stereo.pointsOf(wall(rig, 4, 3)).size() < 20);  // 30 m
}

TEST_CASE("blank and missing images give no points") {
  const CameraRig rig = rigOf(480, 160, 240, 0.5);
  const StereoPoints stereo(rig);
  Frame blank;
  blank.left = tolman::test::gray(480, 160, [](int, int) { return 90L; });
  blank.right = blank.left;
  CHECK(stereo.pointsOf(blank).empty());
  CHECK(stereo.pointsOf(Frame()).empty());
  Frame single = wall(rig, 8, 3);
  single.right = Image();
  CHECK(stereo.pointsOf(single).empty());
}

TEST_CASE(
    "one camera, no calibration, no images, and images that are too narrow: nothing is measured") {
  CHECK(StereoPoints(rigOf(480, 160, 240, 0.5)).canMeasure());
  CHECK_FALSE(StereoPoints(rigOf(480, 160, 240, 0)).canMeasure());
  CHECK_FALSE(StereoPoints(CameraRig()).canMeasure());
  CHECK_FALSE(StereoPoints(rigOf(0, 0, 240, 0.5)).canMeasure());
  CHECK_FALSE(StereoPoints(rigOf(50, 40, 240, 0.5)).canMeasure());
  CHECK_FALSE(StereoPoints(rigOf(480, 8, 240, 0.5)).canMeasure());
  CameraRig uncalibrated = rigOf(480, 160, 240, 0.5);
  uncalibrated.calibrated = false;
  CHECK_FALSE(StereoPoints(uncalibrated).canMeasure());
  CHECK(StereoPoints(rigOf(50, 40, 240, 0.5)).pointsOf(Frame()).empty());
}
