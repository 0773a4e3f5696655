// SPDX-License-Identifier: BSD-3-Clause
// Tracks of many known motions of one texture, and what cannot be tracked.
#include "tracking.hpp"

#include <catch2/catch.hpp>
#include <opencv2/imgproc.hpp>

#include "corner_detection.hpp"
#include "tolman/context.hpp"

namespace tolman::feature_stereo {
namespace {

/// Random, smooth enough for sub-pixel shifts.
cv::Mat texture(std::uint64_t seed) {
  RandomStream random(seed);
  cv::Mat image(160, 240, CV_8U);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      image.at<uchar>(y, x) = static_cast<uchar>(random.below(256));
    }
  }
  cv::GaussianBlur(image, image, {0, 0}, 2);
  cv::normalize(image, image, 0, 255, cv::NORM_MINMAX);
  return image;
}

cv::Mat warped(const cv::Mat& image, const cv::Matx23d& motion) {
  cv::Mat result;
  cv::warpAffine(image, result, motion, image.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT_101);
  return result;
}

cv::Point2f applied(const cv::Matx23d& m, const cv::Point2f& p) {
  const cv::Vec2d q = m * cv::Vec3d(static_cast<double>(p.x), static_cast<double>(p.y), 1);
  return {static_cast<float>(q[0]), static_cast<float>(q[1])};
}

/// Corners well inside the image.
std::vector<cv::Point2f> corners(const cv::Mat& image) {
  return detectCorners(image, {}, {80, 0.01, 40});
}

}  // namespace

TEST_CASE("shifts, small turns and changes of scale are followed to a fraction of a pixel") {
  RandomStream random(8);
  TrackSettings settings;
  settings.levels = 4;
  int all_astray = 0;  // of about 400
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const cv::Mat image = texture(seed);
    const double angle = random.uniform(-0.06, 0.06);
    const double scale = random.uniform(0.96, 1.04);
    const double c = scale * std::cos(angle);
    const double s = scale * std::sin(angle);
    const double cx = 120;
    const double cy = 80;  // about the middle
    const cv::Matx23d motion(c, -s, cx - c * cx + s * cy + random.uniform(-12, 12), s, c,
                             cy - s * cx - c * cy + random.uniform(-12, 12));
    const cv::Mat moved = warped(image, motion);
    const auto from = corners(image);
    auto to = from;
    const auto good =
        trackCorners(FlowPyramid(image, settings.window, settings.levels),
                     FlowPyramid(moved, settings.window, settings.levels), from, to, settings);
    int followed = 0;
    int astray = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (!good[i]) continue;
      (cv::norm(to[i] - applied(motion, from[i])) < 0.3 ? followed : astray) += 1;
    }
    CAPTURE(seed, astray);
    CHECK(astray <= 2);
    all_astray += astray;
    CHECK(followed > 0.9 * static_cast<double>(from.size()));
    CHECK(from.size() > 15);
  }
  CHECK(all_astray <= 6);
}

TEST_CASE("a good guess needs one pyramid level, a bad one is corrected on the coarser levels") {
  const cv::Mat image = texture(3);
  const cv::Matx23d motion(1, 0, 22, 0, 1, -9);
  const cv::Mat moved = warped(image, motion);
  const FlowPyramid a(image, 15, 4);
  const FlowPyramid b(moved, 15, 4);
  const auto from = corners(image);
  const auto countGood = [&](int levels, const cv::Point2f& guess) {
    TrackSettings settings;
    settings.levels = levels;
    auto to = from;
    for (cv::Point2f& p : to) p += guess;
    const auto good = trackCorners(a, b, from, to, settings);
    int right = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      right += good[i] && cv::norm(to[i] - applied(motion, from[i])) < 0.3;
    }
    return right;
  };
  const double most = 0.9 * static_cast<double>(from.size());
  CHECK(countGood(1, {21.5F, -9.5F}) > most);
  CHECK(countGood(1, {0, 0}) < 0.2 * most);  // 22 px are too far for one level
  CHECK(countGood(4, {0, 0}) > 0.8 * most);
}

TEST_CASE("corners of a different image are not tracked") {
  const TrackSettings settings;
  std::size_t kept = 0;
  std::size_t all = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const cv::Mat image = texture(seed);
    const auto from = corners(image);
    auto to = from;
    const auto good = trackCorners(
        FlowPyramid(image, settings.window, settings.levels),
        FlowPyramid(texture(seed + 50), settings.window, settings.levels), from, to, settings);
    for (const bool one : good) kept += one;
    all += good.size();
  }
  CHECK(static_cast<double>(kept) < 0.25 * static_cast<double>(all));
}

TEST_CASE("no track ends outside the image or on a picture without texture") {
  const TrackSettings settings;
  const cv::Mat image = texture(4);
  const FlowPyramid here(image, settings.window, settings.levels);
  const std::vector<cv::Point2f> from = {{4, 80}, {235, 80}, {120, 4}, {120, 155}};
  for (const cv::Point2f& shift :
       {cv::Point2f(-9, 0), cv::Point2f(9, 0), cv::Point2f(0, -9), cv::Point2f(0, 9)}) {
    const FlowPyramid there(warped(image, {1, 0, double(shift.x), 0, 1, double(shift.y)}),
                            settings.window, settings.levels);
    auto to = from;
    const auto good = trackCorners(here, there, from, to, settings);
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (!good[i]) continue;
      CHECK((to[i].x >= 3 && to[i].y >= 3 && to[i].x < 237 && to[i].y < 157));
    }
  }
  auto to = from;
  const FlowPyramid flat(cv::Mat(160, 240, CV_8U, cv::Scalar(90)), settings.window,
                         settings.levels);
  for (const bool good : trackCorners(flat, flat, from, to, settings)) CHECK_FALSE(good);
  std::vector<cv::Point2f> none;
  CHECK(trackCorners(here, here, {}, none, settings).empty());
}

TEST_CASE("a pyramid halves its levels and keeps the image on the first, as a copy") {
  cv::Mat image = texture(5);
  const FlowPyramid pyramid(image, 15, 4);
  REQUIRE(pyramid.levels() == 4);
  for (int level = 0; level < 4; ++level) {
    CHECK(pyramid.level(level).cols == 240 >> level);
    CHECK(pyramid.level(level).rows == 160 >> level);
  }
  const int before = pyramid.level(0).at<uchar>(10, 10);
  image.setTo(0);
  CHECK(int(pyramid.level(0).at<uchar>(10, 10)) == before);
  CHECK(FlowPyramid().empty());
}

}  // namespace tolman::feature_stereo
