// SPDX-License-Identifier: BSD-3-Clause
// Pictures and times of valid files in several containers and codecs.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/data.hpp"
#include "tolman/image_cv.hpp"
#include "video_maker.hpp"

namespace tolman::video {
namespace {

struct Recording {
  const char* name;
  const char* codec;
  double unit_s;  ///< smallest step of time that the container knows
};

}  // namespace

TEST_CASE("each picture has its own time, also where the coder reorders them") {
  const test::TemporaryFolder folder;
  constexpr double kRate = 30000.0 / 1001;
  // avc1 is H.264 with pictures that refer to later ones; OpenCV writes 29.97 into some headers.
  for (const Recording& recording :
       {Recording{"a.mp4", "avc1", 1 / 30000.0}, Recording{"b.mp4", "mp4v", 1 / 30000.0},
        Recording{"c.mkv", "FFV1", 1e-3}, Recording{"d.avi", "MJPG", 1e-5},
        Recording{"e.ts", "MPG2", 1 / 90000.0}}) {
    INFO(recording.name);
    const auto file = folder.path() / recording.name;
    writeFlatVideo(file, 40, kRate, recording.codec);
    const Played played(file);
    CHECK(played.message.empty());
    REQUIRE(played.frames.size() == 40);
    for (int i = 0; i < 40; ++i) {
      const Frame& frame = played.frames[static_cast<std::size_t>(i)];
      CHECK(numberOf(frame.left) == i);
      const double seconds = static_cast<double>(frame.stamp_ns) * 1e-9;
      CHECK(std::abs(seconds - i / kRate) <= recording.unit_s);
    }
  }
}

TEST_CASE("times are exact to the nanosecond where the container's are") {
  const test::TemporaryFolder folder;
  writeFlatVideo(folder.path() / "video.avi", 30, 25, "MJPG");
  const Played played(folder.path() / "video.avi");
  REQUIRE(played.frames.size() == 30);
  for (int i = 0; i < 30; ++i)
    CHECK(played.stamps()[static_cast<std::size_t>(i)] == i * 40'000'000LL);
}

TEST_CASE("black is 0, white is 255, and colours keep their order") {
  const test::TemporaryFolder folder;
  cv::Mat ramp(16, 256, CV_8UC3);
  for (int x = 0; x < 256; ++x) ramp.col(x).setTo(cv::Scalar(x, x, x));
  const cv::Mat blue(16, 256, CV_8UC3, cv::Scalar(200, 80, 30));
  writeVideo(folder.path() / "video.mkv", "FFV1", 10, {ramp, blue});
  const Played grey(folder.path() / "video.mkv");
  REQUIRE(grey.frames.size() == 2);
  for (int x = 0; x < 256; ++x) {
    CHECK(std::abs(int{grey.frames[0].left.row(8)[x]} - x) <= 2);
  }
  const Played colour(folder.path() / "video.mkv", {{"colour", true}});
  REQUIRE(colour.frames.size() == 2);
  const std::uint8_t* pixel = colour.frames[1].left.row(8) + 300;
  CHECK(std::abs(int{pixel[0]} - 200) <= 3);
  CHECK(std::abs(int{pixel[1]} - 80) <= 3);
  CHECK(std::abs(int{pixel[2]} - 30) <= 3);
  const double luminance = 0.299 * 30 + 0.587 * 80 + 0.114 * 200;
  CHECK(std::abs(grey.frames[1].left.row(8)[100] - luminance) <= 3);
}

TEST_CASE("widths that are no multiple of four") {
  const test::TemporaryFolder folder;
  for (const int width : {34, 50, 102}) {
    cv::Mat picture(30, width, CV_8UC1);
    for (int x = 0; x < width; ++x) picture.col(x).setTo(x % 2 == 0 ? 60 : 180);
    const auto file = folder.path() / (std::to_string(width) + ".avi");
    writeVideo(file, "MJPG", 10, {picture});
    const Played played(file);
    REQUIRE(played.frames.size() == 1);
    CHECK(played.frames[0].left.width() == width);
    CHECK(cv::norm(asMat(played.frames[0].left), picture, cv::NORM_INF) <= 40);
  }
}

TEST_CASE("the description says what the file is") {
  const test::TemporaryFolder folder;
  writeFlatVideo(folder.path() / "video.avi", 30, 25, "MJPG");
  CHECK(Played(folder.path() / "video.avi").info.description ==
        "mjpeg in avi, 64x48 px at 25 Hz, 1.2 s, uncalibrated");
}

}  // namespace tolman::video
