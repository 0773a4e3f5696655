// SPDX-License-Identifier: BSD-3-Clause
#include "messages.hpp"

#include <catch2/catch.hpp>

#include "bag_case.hpp"
#include "field_reader.hpp"

namespace tolman::ros_bag {

TEST_CASE("numbers are aligned to their size, in either order of bytes") {
  for (const bool big : {false, true}) {
    const std::string bytes = test::CdrWriter(big)
                                  .number(std::uint8_t{7})
                                  .number(0.25)
                                  .text("abc")
                                  .number(std::uint16_t{513})
                                  .number(-1.5F)
                                  .bytes();
    FieldReader fields(asBytes(bytes));
    CHECK(fields.number<std::uint8_t>() == 7);
    CHECK(fields.number<double>() == 0.25);
    CHECK(fields.text() == "abc");
    CHECK(fields.number<std::uint16_t>() == 513);
    CHECK(fields.number<float>() == -1.5F);
    CHECK(fields.ok());
    CHECK(fields.number<std::uint8_t>() == 0);
    CHECK_FALSE(fields.ok());
  }
}

TEST_CASE("lengths beyond the end and unknown kinds of CDR are refused") {
  const std::string long_text(
      "\0\1\0\0\xff\xff\xff\x7f"
      "abc",
      11);
  FieldReader text(asBytes(long_text));
  CHECK(text.text().empty());
  CHECK_FALSE(text.ok());
  FieldReader sequence(asBytes(long_text));
  CHECK(sequence.count(8) == 0);
  CHECK_FALSE(sequence.ok());
  CHECK_FALSE(FieldReader(asBytes(std::string("\0\7\0\0abcd", 8))).ok());
  CHECK_FALSE(FieldReader(asBytes("ab")).ok());
}

TEST_CASE("an image message, cut anywhere, is whole or none") {
  for (const bool big : {false, true}) {
    const std::string bytes =
        test::imageMessage({stampOf(3), 4, 2, "bgr8", std::string(26, 'x')}, big);
    const auto image = readImage(asBytes(bytes));
    REQUIRE(image);
    CHECK(image->stamp_ns == stampOf(3));
    CHECK(headerStamp(asBytes(bytes)) == stampOf(3));
    CHECK(image->width == 4);
    CHECK(image->height == 2);
    CHECK(image->encoding == "bgr8");
    CHECK(image->step == 13);
    CHECK(image->data.size() == 26);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      CHECK_FALSE(readImage(asBytes(bytes).first(size)));
    }
  }
}

TEST_CASE("calibration, inertial measurements and odometry") {
  const auto info =
      readCameraInfo(asBytes(test::cameraInfoMessage(test::plainCamera(8, 6, 7, 0.5))));
  REQUIRE(info);
  CHECK(info->width == 8);
  CHECK(info->model == "plumb_bob");
  CHECK(info->D.size() == 5);
  CHECK(info->K[2] == 3.5);
  CHECK(info->P[3] == -3.5);
  const auto imu = readImu(asBytes(test::imuMessage(5, {1, 2, 3}, {4, 5, 9.81})));
  REQUIRE(imu);
  CHECK(imu->angular_velocity == std::array<double, 3>{1, 2, 3});
  CHECK(imu->linear_acceleration == std::array<double, 3>{4, 5, 9.81});
  const auto odometry = readOdometry(asBytes(test::odometryMessage(stampOf(1), 3, -2, 0)));
  REQUIRE(odometry);
  CHECK(odometry->stamp_ns == stampOf(1));
  CHECK(odometry->position == std::array<double, 3>{3, -2, 0});
  CHECK(odometry->orientation[3] == 1);
  CHECK_FALSE(readImu(asBytes(test::imuMessage(5, {NAN, 2, 3}, {4, 5, 6}))));
}

}  // namespace tolman::ros_bag
