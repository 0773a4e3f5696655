// SPDX-License-Identifier: BSD-3-Clause
// Contents of a frame message: the reduced image, recent points, and cells, all of limited size.
#include "frame_encoder.hpp"

#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>

#include "browser.hpp"
#include "tolman/context.hpp"

namespace tolman::web_viewer {
namespace {

Image painted(int width, int height, auto&& grey) {
  return Image::create(width, height, PixelFormat::Gray8, [&](std::uint8_t* pixel) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) *pixel++ = static_cast<std::uint8_t>(grey(x, y));
    }
  });
}

cv::Mat decoded(const std::string& jpeg) {
  return cv::imdecode(std::vector<char>(jpeg.begin(), jpeg.end()), cv::IMREAD_GRAYSCALE);
}

const PackedArray* arrayOf(const EncodedFrame& frame, const std::string& name) {
  for (const PackedArray& array : frame.arrays) {
    if (array.name == name) return &array;
  }
  return nullptr;
}

FrameCopy withPoints(std::int64_t frame, std::int64_t points_frame, Eigen::Index count) {
  FrameCopy copy;
  copy.frame = frame;
  copy.points_frame = points_frame;
  copy.points.resize(4, count);
  for (Eigen::Index i = 0; i < copy.points.size(); ++i) {
    copy.points.data()[i] = static_cast<float>(i);
  }
  return copy;
}

}  // namespace

TEST_CASE("an image is reduced by the least whole factor that makes it narrow enough") {
  struct Case {
    int width, height, limit;
    cv::Size expected;
  };
  for (const Case& c : {Case{640, 480, 640, {640, 480}}, Case{641, 480, 640, {320, 240}},
                        Case{1241, 376, 640, {620, 188}}, Case{1281, 376, 640, {427, 125}},
                        Case{100, 3, 10, {33, 1}},  // not below one row
                        Case{1, 1, 1, {1, 1}}}) {
    const Image image = painted(c.width, c.height, [](int x, int) { return x % 200; });
    CAPTURE(c.width, c.limit);
    CHECK(decoded(jpeg(image, {c.limit, 70})).size() == c.expected);
  }
  CHECK(jpeg(Image(), {640, 70}).empty());
}

TEST_CASE("a pixel of the reduced image is the mean of those that it stands for") {
  // Smooth, so that JPEG at quality 100 keeps it to a few grey levels.
  const auto grey = [](int x, int y) { return 40 + (x * 3 + y * 2) / 10; };
  const cv::Mat small = decoded(jpeg(painted(300, 200, grey), {100, 100}));
  REQUIRE(small.size() == cv::Size(100, 66));
  for (int y = 0; y < small.rows; y += 5) {
    for (int x = 0; x < small.cols; x += 5) {
      double sum = 0;
      for (int k = 0; k < 9; ++k) sum += grey(3 * x + k % 3, 3 * y + k / 3);
      REQUIRE(std::abs(sum / 9 - int(small.at<std::uint8_t>(y, x))) < 3);
    }
  }
}

TEST_CASE("points are sent while they fit the image, at most 20,000 of them") {
  CHECK(arrayOf(encodeFrame(withPoints(50, 40, 7), {}), "points") != nullptr);
  CHECK(arrayOf(encodeFrame(withPoints(51, 40, 7), {}), "points") == nullptr);  // too old
  CHECK(arrayOf(encodeFrame(withPoints(51, -1, 7), {}), "points") == nullptr);
  CHECK(arrayOf(encodeFrame(withPoints(51, 51, 0), {}), "points") == nullptr);
  const EncodedFrame many = encodeFrame(withPoints(9, 9, 30'000), {});
  const PackedArray* points = arrayOf(many, "points");
  REQUIRE(points != nullptr);
  CHECK(points->shape == std::vector<std::size_t>{20'000, 4});
  CHECK(points->bytes->size() == 20'000 * 4 * sizeof(float));
  CHECK(many.header.points_frame == 9);
  // Row i is point i: its four numbers follow one another.
  const test::Container got = test::parseContainer(storedMessage(many, {}));
  const auto values = got.arrays.at("points").as<float>();
  for (std::size_t i = 0; i < values.size(); i += 997) CHECK(values[i] == static_cast<float>(i));
}

TEST_CASE("cells are sent in order until a message would be too large") {
  FrameCopy copy;
  copy.frame = 3;
  copy.cells = {{"small", {2, 3}, std::vector<float>(6, 0.5F)},
                {"large", {1 << 19}, std::vector<float>(1U << 19U)},
                {"too large", {1 << 19}, std::vector<float>(1U << 19U)},
                {"after", {1}, {1}}};
  const EncodedFrame frame = encodeFrame(copy, {});
  REQUIRE(arrayOf(frame, "cells.small") != nullptr);
  CHECK(arrayOf(frame, "cells.small")->shape == std::vector<std::size_t>{2, 3});
  CHECK(arrayOf(frame, "cells.large") != nullptr);
  CHECK(arrayOf(frame, "cells.too large") == nullptr);
  CHECK(arrayOf(frame, "image") == nullptr);  // a frame without an image
}

TEST_CASE("a stored message has the events, with long texts cut") {
  RunEvent brief;
  brief.message = "odometry: lost";
  brief.frame = 8;
  RunEvent endless;
  endless.message = std::string(5000, 'a');
  const test::Container got =
      test::parseContainer(storedMessage(encodeFrame(withPoints(8, -1, 0), {}), {brief, endless}));
  REQUIRE(got.header["events"].size() == 2);
  CHECK(got.header["events"][0]["message"] == "odometry: lost");
  CHECK(got.header["events"][0]["frame"] == 8);
  CHECK(got.header["events"][1]["message"] == std::string(1000, 'a'));
  CHECK(got.header["frame"] == 8);
}

}  // namespace tolman::web_viewer
