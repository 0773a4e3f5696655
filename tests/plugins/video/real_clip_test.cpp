// SPDX-License-Identifier: BSD-3-Clause
// KITTI 03 as a video: the pictures and times that were encoded.
#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>

#include "support/data.hpp"
#include "tolman/image_cv.hpp"
#include "video_maker.hpp"

namespace tolman::video {
namespace {

std::vector<cv::Mat> readClip(const std::filesystem::path& folder, int count) {
  std::vector<cv::Mat> images;
  for (int i = 0; i < count; ++i) {
    std::array<char, 16> name{};
    std::snprintf(name.data(), name.size(), "%06d.jpg", i);
    const auto file = folder / "image_0" / name.data();
    const cv::Mat image = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
    REQUIRE_FALSE(image.empty());
    images.push_back(image(cv::Rect(0, 0, 1240, 374)).clone());  // coders want even sizes
  }
  return images;
}

}  // namespace

TEST_CASE("a drive as a video without and with loss", "[data]") {
  const auto data = test::dataOrSkip("kitti_clips/03_left");
  if (!data) return;
  const test::TemporaryFolder folder;
  const std::vector<cv::Mat> images = readClip(*data, 30);
  writeVideo(folder.path() / "exact.mkv", "FFV1", 10, images);
  const Played exact(folder.path() / "exact.mkv");
  CHECK(exact.message.empty());
  REQUIRE(exact.frames.size() == images.size());
  for (std::size_t i = 0; i < images.size(); ++i) {
    // 8 bits of grey pass through the 220 levels of a video: at most one step of rounding and back.
    CHECK(cv::norm(asMat(exact.frames[i].left), images[i], cv::NORM_INF) <= 2);
    CHECK(exact.frames[i].stamp_ns == static_cast<std::int64_t>(i) * 100'000'000);
  }
  writeVideo(folder.path() / "small.mp4", "avc1", 10, images);
  const Played small(folder.path() / "small.mp4");
  REQUIRE(small.frames.size() == images.size());
  for (std::size_t i = 0; i < images.size(); ++i) {
    const auto difference = [&](std::size_t k) {
      return cv::norm(asMat(small.frames[i].left), images[k], cv::NORM_L1);
    };
    CHECK(difference(i) / static_cast<double>(images[i].total()) < 8);
    if (i > 0) CHECK(difference(i) < difference(i - 1));
    CHECK(small.frames[i].stamp_ns == static_cast<std::int64_t>(i) * 100'000'000);
  }
}

}  // namespace tolman::video
