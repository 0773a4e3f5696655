// SPDX-License-Identifier: BSD-3-Clause
// Calibrations that cannot be of these images: resized ones, and other units.
#include "engine/camera_check.hpp"

#include <catch2/catch.hpp>

#include "support/gray_images.hpp"

using namespace tolman;
using namespace tolman::engine;

namespace {

std::vector<std::string> doubtsOf(int width, int height, const Pinhole& pinhole) {
  CameraRig rig;
  rig.width = width;
  rig.height = height;
  rig.calibrated = true;
  rig.pinhole = pinhole;
  return cameraDoubts({}, rig);
}

RawCamera rawCamera(LensModel model, const Pinhole& pinhole) {
  RawCamera camera;
  camera.model = model;
  camera.width = 752;
  camera.height = 480;
  camera.pinhole = pinhole;
  return camera;
}

constexpr Pinhole kEuroc = {458.6, 457.3, 367.2, 248.4};

}  // namespace

TEST_CASE("a baseline below 1 cm or above 10 m is doubted, with its value and the unit") {
  const auto doubts = [](double baseline) {
    CameraRig rig;
    rig.baseline = baseline;
    return cameraDoubts({}, rig);
  };
  for (const double usual : {0.0, 0.01, 0.063, 0.54, 10.0}) CHECK(doubts(usual).empty());
  CHECK_THAT(doubts(0.0012).at(0), Catch::StartsWith("the two cameras are 0.0012 m apart"));
  CHECK_THAT(doubts(50).at(0), Catch::StartsWith("the two cameras are 50 m apart"));
  CHECK_THAT(doubts(537).at(0), Catch::Contains("in metres, not mm"));
}

TEST_CASE("a principal point far from the middle is doubted: were the images resized?") {
  const auto resized = doubtsOf(613, 185, {718.9, 718.9, 601.9, 183.1});
  REQUIRE(resized.size() == 1);
  CHECK(resized[0] ==
        "the principal point (601.9, 183.1) is far from the middle of the 613x185 image; were the "
        "images resized after the calibration? Then scale fx, fy, cx, cy as well");
  const auto count = [](double cx, double cy) {
    return doubtsOf(613, 185, {718.9, 718.9, cx, cy}).size();
  };
  CHECK(count(300.9, 91.5) == 0);
  CHECK(count(0.26 * 613, 0.74 * 185) == 0);
  CHECK(count(0.24 * 613, 92) == 1);
  CHECK(count(300.9, 0.76 * 185) == 1);
  CHECK(count(-5, 91.5) == 1);
}

TEST_CASE("a focal length that rectified images do not have is doubted") {
  const auto doubts = [](double f) { return doubtsOf(1226, 370, {f, f, 601.9, 183.1}); };
  CHECK(doubts(707.1).empty());  // KITTI 06
  CHECK(doubts(400).empty());    // 114 degrees
  const auto halved = doubts(353.5);
  REQUIRE(halved.size() == 1);
  CHECK(
      halved[0] ==
      "the focal length (353.5, 353.5) gives the 1226x370 image a view of 120 degrees, which such "
      "cameras do not have; is it that of these images, in pixels? Depths and paths are wrong by "
      "its error");
  CHECK(doubts(70710).size() == 1);
}

TEST_CASE("focal lengths that differ by more than 5 % are doubted, in either direction") {
  const auto doubts = [](double fx, double fy) {
    return doubtsOf(1226, 370, {fx, fy, 601.9, 183.1});
  };
  CHECK(doubts(700, 734).empty());
  CHECK(doubts(734, 700).empty());
  CHECK_THAT(doubts(707.1, 1414.2).at(0),
             Catch::StartsWith("the focal lengths are 707.1 px horizontally and 1414.2 px "
                               "vertically, and pixels of cameras are nearly square"));
  CHECK(doubts(740, 700).size() == 1);
}

TEST_CASE("cameras without images or calibration are not doubted") {
  CHECK(doubtsOf(0, 0, {}).empty());
  CameraRig rig;
  rig.width = 640;
  rig.height = 480;
  CHECK(cameraDoubts({}, rig).empty());
}

TEST_CASE("raw cameras are named, and may be wide") {
  const auto doubts = [](const RawRig& rig) { return cameraDoubts(rig, {}); };
  RawRig rig;
  rig.cameras = {rawCamera(LensModel::RadialTangential, kEuroc)};
  CHECK(doubts(rig).empty());
  rig.cameras.push_back(rawCamera(LensModel::RadialTangential, {915, 915, 735, 498}));
  REQUIRE(doubts(rig).size() == 1);
  CHECK_THAT(doubts(rig)[0],
             Catch::StartsWith("the principal point of the right camera (735.0, 498.0) is far"));
  rig.cameras.back() = rawCamera(LensModel::Equidistant, {596, 457.3, 367.2, 248.4});
  REQUIRE(doubts(rig).size() == 1);
  CHECK_THAT(doubts(rig)[0], Catch::StartsWith("the focal lengths of the right camera are 596 px"));
  const Pinhole wide = {190, 190, 376, 240};  // 126 degrees as a pinhole
  rig.cameras = {rawCamera(LensModel::RadialTangential, wide)};
  CHECK(doubts(rig).empty());
  const Pinhole metres = {0.46, 0.46, 376, 240};
  rig.cameras = {rawCamera(LensModel::RadialTangential, metres)};
  REQUIRE(doubts(rig).size() == 1);
  CHECK_THAT(doubts(rig)[0], Catch::Contains("a view of 180 degrees"));
  rig.cameras = {rawCamera(LensModel::Equidistant, metres)};
  CHECK(doubts(rig).empty());
}

TEST_CASE("one in ten thousand values may be bright in an image that is nearly black") {
  const auto withBright = [](int pixels, int value) {
    return test::gray(200, 100, [=](int x, int y) { return y == 0 && x < pixels ? value : 15; });
  };
  CHECK(isNearlyBlack(withBright(2, 255)));
  CHECK_FALSE(isNearlyBlack(withBright(3, 255)));
  CHECK_FALSE(isNearlyBlack(withBright(3, 64)));
  CHECK(isNearlyBlack(withBright(200, 63)));
  CHECK_FALSE(isNearlyBlack(Image()));
}
