// SPDX-License-Identifier: BSD-3-Clause
#include "camera_rigs.hpp"

#include <catch2/catch.hpp>

#include "bag_case.hpp"

namespace tolman::ros_bag {
namespace {

constexpr ImageSize kSize{640, 480};

/// A camera with its CameraInfo.
struct Described {
  Described(const std::string& name, const std::string& info)
      : bytes(info),
        topic{"/" + name + "/image_raw", "/" + name + "/camera_info", asBytes(bytes)} {}

  std::string bytes;
  CameraTopic topic;
};

Described described(const std::string& name, double baseline, std::vector<double> D = {}) {
  test::RosCamera camera = test::plainCamera(640, 480, 500, baseline);
  camera.D = std::move(D);
  return {name, test::cameraInfoMessage(camera)};
}

CameraTopic plain(const std::string& name) { return {"/" + name + "/image_raw", "", std::nullopt}; }

std::string refusal(const CameraParameters& parameters, const CameraTopic& left,
                    const CameraTopic* right) {
  return makeRigs(parameters, kSize, left, right).status().message();
}

}  // namespace

TEST_CASE("cameras by parameters, also beside a CameraInfo") {
  CameraParameters given;
  given.pinhole = {400};
  const Described left = described("left", 0);
  const auto one = makeRigs(given, kSize, left.topic, nullptr);
  REQUIRE(one.isOk());
  CHECK(one.value().rectified.pinhole.fx == 400);
  CHECK(one.value().rectified.pinhole.cx == 319.5);
  CHECK(one.value().rectified.baseline == 0);
  CHECK(one.value().suffix().empty());
  const CameraTopic right = plain("right");
  CHECK(refusal(given, left.topic, &right) ==
        "pinhole is given for two cameras without baseline; give both");
  given.baseline = 0.3;
  CHECK(makeRigs(given, kSize, left.topic, &right).value().rectified.baseline == 0.3);
  CHECK(makeRigs(given, kSize, left.topic, nullptr).value().rectified.baseline == 0);
  given.pinhole = {400, 400, 640, 20};
  CHECK(refusal(given, left.topic, nullptr) ==
        "the principal point of pinhole is outside of the image of 640x480 px; give the "
        "calibration of "
        "this camera");
}

TEST_CASE("cameras by CameraInfo: rectified, raw, none") {
  const Described left = described("left", 0);
  const Described right = described("right", 0.2);
  const auto rectified = makeRigs({}, kSize, left.topic, &right.topic);
  REQUIRE(rectified.isOk());
  CHECK(rectified.value().rectified.baseline == Approx(0.2).margin(1e-15));
  CHECK(rectified.value().raw.cameras.empty());

  const Described bent = described("left", 0, {0.1, -0.2, 0.001, 0.002, 0.05});
  const auto raw = makeRigs({}, kSize, bent.topic, nullptr);
  REQUIRE(raw.isOk());
  CHECK(raw.value().raw.cameras.size() == 1);
  CHECK_FALSE(raw.value().rectified.calibrated);
  CHECK(raw.value().suffix() == ", raw");

  const auto uncalibrated = makeRigs({}, kSize, plain("cam"), nullptr);
  REQUIRE(uncalibrated.isOk());
  CHECK(uncalibrated.value().rectified.width == 640);
  CHECK(uncalibrated.value().rectified.height == 480);
  CHECK(uncalibrated.value().suffix() == ", uncalibrated");
}

TEST_CASE("a calibration that is not complete is told with the topic and a remedy") {
  const Described left = described("left", 0);
  const Described right = described("right", 0.2);
  const CameraTopic without = plain("right");
  CHECK(refusal({}, left.topic, &without) ==
        "there is no CameraInfo beside /left/image_raw and /right/image_raw; set left_info and "
        "right_info, give pinhole and baseline, or set mono: true");
  const Described cut("left", left.bytes.substr(0, left.bytes.size() / 2));
  CHECK(refusal({}, cut.topic, nullptr) ==
        "/left/camera_info: is no complete CameraInfo; give pinhole of rectified images");
  const Described cut_right("right", right.bytes.substr(0, right.bytes.size() / 2));
  CHECK(refusal({}, left.topic, &cut_right.topic) ==
        "/right/camera_info: is no complete CameraInfo; give pinhole and baseline");
  CHECK(makeRigs({}, {320, 240}, left.topic, nullptr)
            .status()
            .message()
            .starts_with("/left/camera_info: "));
}

TEST_CASE("parameters that contradict each other") {
  CameraParameters both;
  CHECK(checkCombination(both).isOk());
  both.mono = true;
  both.right = "/right";
  CHECK(checkCombination(both).message() == "mono and right are both given; keep one");
  CameraParameters half;
  half.baseline = 0.5;
  CHECK(checkCombination(half).message() == "baseline is given without pinhole; give both");
}

}  // namespace tolman::ros_bag
