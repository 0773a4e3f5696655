// SPDX-License-Identifier: BSD-3-Clause
#include "camera_calibration.hpp"

#include <catch2/catch.hpp>

#include "bag_case.hpp"

namespace tolman::ros_bag {
namespace {

CameraInfoMessage messageOf(const test::RosCamera& camera) {
  return *readCameraInfo(asBytes(test::cameraInfoMessage(camera)));
}

/// A pair with distortion, of cameras that are turned by `turn` against the rectified ones.
CameraInfos distorted(double turn) {
  test::RosCamera left = test::plainCamera(640, 480, 500, 0);
  test::RosCamera right = test::plainCamera(640, 480, 500, 0.2);
  left.D = {0.1, -0.2, 0.001, 0.002, 0.05};
  right.D = left.D;
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  right.R = {c, 0, s, 0, 1, 0, -s, 0, c};
  return {messageOf(left), messageOf(right)};
}

}  // namespace

TEST_CASE("rectified images: the rig of P") {
  const CameraInfos infos{messageOf(test::plainCamera(640, 480, 500, 0)),
                          messageOf(test::plainCamera(640, 480, 500, 0.2))};
  CHECK(isRectified("/left/image", infos));
  const auto rig = rectifiedRig(infos, 640, 480);
  REQUIRE(rig.isOk());
  CHECK(rig.value().calibrated);
  CHECK(rig.value().pinhole.fx == 500);
  CHECK(rig.value().pinhole.cx == 319.5);
  CHECK(rig.value().baseline == Approx(0.2).margin(1e-15));
  CHECK_FALSE(isRectified("/left/image_raw", distorted(0)));
  CHECK(isRectified("/left/image_rect", distorted(0)));
  CHECK(isRectified("/left/image_rect_color/compressed", distorted(0)));
  for (const char* raw : {"/direct/image_raw", "/rectangular/image", "/left/image_unrectified"}) {
    CHECK_FALSE(isRectified(raw, distorted(0)));
  }
}

TEST_CASE("raw images: models, poses and the prescribed rectified cameras") {
  const CameraInfos infos = distorted(0.1);
  const auto rig = rawRig(infos, 640, 480);
  REQUIRE(rig.isOk());
  REQUIRE(rig.value().cameras.size() == 2);
  const RawCamera& right = rig.value().cameras[1];
  CHECK(right.model == LensModel::RadialTangential);
  CHECK(right.distortion[4] == 0.05);
  CHECK(right.distortion[5] == 0);
  CHECK(rig.value().has_rectified);
  CHECK(rig.value().rectified.baseline == Approx(0.2));
  // A point of the right camera's axis in the frame of the left one, by hand.
  const Eigen::Vector3d point = right.T_reference_camera * Eigen::Vector3d(0, 0, 1);
  CHECK(point.x() == Approx(0.2 + std::sin(0.1)));
  CHECK(point.z() == Approx(std::cos(0.1)));
}

TEST_CASE("other models, and one camera") {
  test::RosCamera camera = test::plainCamera(640, 480, 500, 0);
  camera.model = "equidistant";
  camera.D = {0.01, 0.02, 0.03, 0.04};
  const auto fisheye = rawRig({messageOf(camera), std::nullopt}, 640, 480);
  REQUIRE(fisheye.isOk());
  CHECK(fisheye.value().cameras[0].model == LensModel::Equidistant);
  CHECK_FALSE(fisheye.value().has_rectified);
  camera.model = "thin_prism";
  CHECK(rawRig({messageOf(camera), std::nullopt}, 640, 480).status().message().find("thin_prism") !=
        std::string::npos);
}

TEST_CASE("a right camera of another size, focal length or centre is refused") {
  const auto left = messageOf(test::plainCamera(640, 480, 500, 0));
  const auto refusal = [&](const CameraInfoMessage& right) {
    return rectifiedRig({left, right}, 640, 480).status().message();
  };
  CHECK(refusal(messageOf(test::plainCamera(640, 480, 500, 0.2))).empty());
  CHECK(refusal(messageOf(test::plainCamera(640, 480, 510, 0.2)))
            .starts_with("the two rectified cameras have different focal lengths or centres"));
  CameraInfoMessage shifted = messageOf(test::plainCamera(640, 480, 500, 0.2));
  shifted.P[2] -= 10;  // disparities would be 10 px too large
  CHECK(refusal(shifted).find("by 10.0") != std::string::npos);
  CHECK(refusal(messageOf(test::plainCamera(320, 240, 500, 0.2))).starts_with("is of 320x240 px"));
}

TEST_CASE("calibration that is none") {
  const auto message = [](const test::RosCamera& camera, int width) {
    return rectifiedRig({messageOf(camera), std::nullopt}, width, 480).status().message();
  };
  CHECK(message(test::plainCamera(640, 480, 500, 0), 320) ==
        "is of 640x480 px, and the images have 320x480; give pinhole of rectified images, or "
        "record the "
        "right one");
  test::RosCamera zero = test::plainCamera(640, 480, 0, 0);
  CHECK(message(zero, 640).find("was not calibrated") != std::string::npos);
}

TEST_CASE("a baseline that is none says what was found, and the remedy that helps") {
  const auto left = messageOf(test::plainCamera(640, 480, 500, 0));
  const auto right = messageOf(test::plainCamera(640, 480, 500, 0.537));
  const auto refusal = [](const CameraInfoMessage& one, const CameraInfoMessage& other) {
    return rectifiedRig({one, other, "/l/camera_info", "/r/camera_info"}, 640, 480)
        .status()
        .message();
  };
  CHECK(refusal(left, right).empty());
  CHECK(
      refusal(left, messageOf(test::plainCamera(640, 480, 500, 537))) ==
      "/r/camera_info: has P[3] = -268500 and fx = 500, a baseline of 537 m; it must be 1 mm to "
      "5 m: P[3] is -fx times the baseline in metres, not in mm or cm; correct it, or give pinhole "
      "and baseline");
  // The sign of P[3] is not decisive: the images say whether left and right are exchanged.
  CHECK(refusal(right, left).empty());
  const auto wrong_sign = messageOf(test::plainCamera(640, 480, 500, -0.537));
  CHECK(refusal(left, wrong_sign).empty());
  CHECK(hasWrongSign({left, wrong_sign}));
  CHECK_FALSE(hasWrongSign({left, right}));
  CHECK(refusal(left, left) ==
        "/r/camera_info: has P[3] = 0 and fx = 500, a baseline of 0 m: that of a single camera; "
        "calibrate the two as a pair, give pinhole and baseline, or set mono: true");
  CameraInfoMessage without = right;
  without.P.fill(0);
  CHECK(refusal(left, without).starts_with("/r/camera_info: has no P, so the baseline is not"));
}

TEST_CASE("the baseline is the distance of the two cameras, also of a pair beside a third") {
  CameraInfoMessage left = messageOf(test::plainCamera(640, 480, 500, 0));
  CameraInfoMessage right = messageOf(test::plainCamera(640, 480, 500, 0.5));
  left.P[3] = 30;  // both are moved against camera 0, as in KITTI's colour pair
  right.P[3] += 30;
  left.P[7] = 0.1;
  right.P[7] = 1;
  const auto rig = rectifiedRig({left, right}, 640, 480);
  REQUIRE(rig.isOk());
  CHECK(rig.value().baseline == Approx(0.5));
  right.P[7] = 100;  // 0.2 m
  CHECK_THAT(rectifiedRig({left, right}, 640, 480).status().message(),
             Catch::StartsWith("is -0.1998 m below and 0 m before the left camera by P[7] and"));
}

TEST_CASE("matrices of another form are refused, not read in part") {
  const CameraInfoMessage sound = messageOf(test::plainCamera(640, 480, 500, 0));
  const auto refusal = [&](auto change) {
    CameraInfoMessage changed = sound;
    change(changed);
    return rectifiedRig({changed, std::nullopt}, 640, 480).status().message();
  };
  CHECK(refusal([](auto&) {}).empty());
  const std::string of_P = "has a matrix P that is not of the form fx 0 cx, 0 fy cy, 0 0 1";
  CHECK_THAT(refusal([](auto& c) { c.P[10] = 2; }), Catch::StartsWith(of_P));
  CHECK_THAT(refusal([](auto& c) { c.P[1] = 30; }), Catch::StartsWith(of_P));
  CHECK_THAT(refusal([](auto& c) { c.K[8] = 2; }), Catch::StartsWith("has a matrix K that is"));
  CHECK(refusal([](auto& c) { c.P.fill(0); }).empty());  // K is used then
  test::RosCamera binned = test::plainCamera(640, 480, 500, 0);
  binned.binning = 2;
  CHECK_THAT(rectifiedRig({messageOf(binned), std::nullopt}, 640, 480).status().message(),
             Catch::StartsWith("has binning or a region of interest"));
}

TEST_CASE("a rotation that is none is refused, and zeros are no rotation") {
  CameraInfos infos = distorted(0.1);
  infos.right->R[0] = 0.5;
  CHECK_THAT(rawRig(infos, 640, 480).status().message(), Catch::StartsWith("has no rotation in R"));
  infos.right->R.fill(0);
  REQUIRE(rawRig(infos, 640, 480).isOk());
  CHECK(rawRig(infos, 640, 480).value().cameras[1].R_rectified_camera.isIdentity());
  CameraInfos plain{messageOf(test::plainCamera(640, 480, 500, 0)), std::nullopt};
  plain.left.R[8] = -1;
  CHECK_FALSE(isRectified("/camera/image", plain));  // so that it is refused
}

TEST_CASE("images without distortion are raw if their matrix is not that of rectified ones") {
  CameraInfos infos{messageOf(test::plainCamera(640, 480, 500, 0)),
                    messageOf(test::plainCamera(640, 480, 500, 0.2))};
  CHECK(isRectified("/left/image", infos));
  infos.right->K[0] = 400;
  CHECK_FALSE(isRectified("/left/image", infos));
  const auto rig = rawRig(infos, 640, 480);
  REQUIRE(rig.isOk());
  CHECK(rig.value().cameras[1].pinhole.fx == 400);
  CHECK(rig.value().rectified.pinhole.fx == 500);
}

TEST_CASE("the topic of the camera that is wrong is named") {
  const auto left = messageOf(test::plainCamera(640, 480, 500, 0));
  const auto small = messageOf(test::plainCamera(320, 240, 500, 0.2));
  const auto message = [](CameraInfos infos) {
    infos.left_name = "/l";
    infos.right_name = "/r";
    return rectifiedRig(infos, 640, 480).status().message();
  };
  CHECK(message({left, small}).starts_with("/r: is of 320x240 px"));
  CHECK(message({small, left}).starts_with("/l: is of 320x240 px"));
  CameraInfos raw = distorted(0.1);
  raw.right->D = {1, 2, 3};
  raw.left_name = "/l";
  raw.right_name = "/r";
  CHECK(
      rawRig(raw, 640, 480).status().message().starts_with("/r: has 3 coefficients of the model"));
}

}  // namespace tolman::ros_bag
