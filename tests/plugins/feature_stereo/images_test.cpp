// SPDX-License-Identifier: BSD-3-Clause
// Corners, tracking and stereo matching on rendered images, where the geometry is known.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <set>

#include "corner_detection.hpp"
#include "stereo_matching.hpp"
#include "support/street_scene.hpp"
#include "tolman/image_cv.hpp"

using namespace tolman;
using namespace tolman::feature_stereo;

namespace {

Frame streetAt(double z) {
  return test::streetFrame(0, Eigen::Isometry3d(Eigen::Translation3d(0, 0, z)));
}

/// Disparity of the first surface that the pixel's ray meets: the planes of the rendered street.
double trueDisparity(const cv::Point2f& pixel) {
  const CameraRig rig = test::streetRig();
  const Eigen::Vector3d ray = rig.pinhole.ray({pixel.x, pixel.y});
  double depth = 60;
  if (ray.y() > 0) depth = std::min(depth, 1.5 / ray.y());
  if (ray.x() < 0) depth = std::min(depth, -5 / ray.x());
  if (ray.x() > 0) depth = std::min(depth, 6 / ray.x());
  return rig.pinhole.fx * rig.baseline / depth;
}

float searchRow(const cv::Mat& left, const cv::Mat& right, cv::Point corner, int max_disparity) {
  const FlowPyramid a(left, 15, 1);
  const FlowPyramid b(right, 15, 1);
  return RowSearch(a.padded(0), b.padded(0), max_disparity).find(corner);
}

}  // namespace

TEST_CASE("corners lie one to a cell, away from the border and from occupied cells") {
  const Frame frame = streetAt(0);
  const cv::Mat gray = asMat(frame.left);
  const CornerSettings settings{150, 0.003, 10};
  const auto corners = detectCorners(gray, {}, settings);
  CHECK(corners.size() > 75);
  const int cell = static_cast<int>(std::sqrt(480.0 * 200 / 150));
  std::set<std::pair<int, int>> cells;
  for (const cv::Point2f& c : corners) {
    CHECK(cells.insert({int(c.x) / cell, int(c.y) / cell}).second);
    CHECK((c.x >= 10 && c.y >= 10 && c.x < 470 && c.y < 190));
  }
  for (const cv::Point2f& c : detectCorners(gray, corners, settings)) {
    CHECK(cells.insert({int(c.x) / cell, int(c.y) / cell}).second);
  }
}

TEST_CASE("a constant image and a tiny one have no corners") {
  CHECK(detectCorners(cv::Mat(100, 100, CV_8U, cv::Scalar(128)), {}, {}).empty());
  CHECK(detectCorners(cv::Mat(8, 8, CV_8U, cv::Scalar(128)), {}, {}).empty());
}

TEST_CASE(
    "tracking finds a known shift to a tenth of a pixel or so, and refuses what left the image") {
  const Frame frame = streetAt(0);
  const cv::Mat gray = asMat(frame.left);
  cv::Mat moved;
  const cv::Matx23d shift(1, 0, 7.3, 0, 1, -2.6);
  cv::warpAffine(gray, moved, shift, gray.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT_101);
  const TrackSettings settings;
  const auto from = detectCorners(gray, {}, {150, 0.01, 12});
  auto to = from;
  const auto good =
      trackCorners(FlowPyramid(gray, settings.window, settings.levels),
                   FlowPyramid(moved, settings.window, settings.levels), from, to, settings);
  int followed = 0;
  int exact = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i].x > 465) CHECK_FALSE((good[i] && to[i].x > 477));
    // Where the shifted image has no source its border is mirrored.
    if (!good[i] || from[i].x < 20 || from[i].x > 455 || from[i].y < 20 || from[i].y > 180)
      continue;
    const double error = cv::norm(to[i] - from[i] - cv::Point2f(7.3F, -2.6F));
    CHECK(error < 0.25);  // the far end of the street has little contrast
    ++followed;
    exact += error < 0.1 ? 1 : 0;
  }
  CHECK(followed > 60);
  CHECK(10 * exact >= 9 * followed);
}

TEST_CASE("stereo matching finds the disparity of the street, without guesses") {
  const Frame frame = streetAt(0);
  const TrackSettings track;
  const FlowPyramid left(asMat(frame.left), track.window, track.levels);
  const FlowPyramid right(asMat(frame.right), track.window, 2);
  StereoSettings settings;
  settings.track.levels = 2;
  settings.max_disparity = 60;
  const auto corners = detectCorners(left.level(0), {}, {200, 0.01, 12});
  const std::vector<float> none(corners.size(), kNoDisparity);
  const auto disparities = matchStereo(left, right, corners, none, settings);
  std::vector<double> errors;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!std::isnan(disparities[i])) errors.push_back(disparities[i] - trueDisparity(corners[i]));
  }
  REQUIRE(errors.size() > 100);
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  CHECK(*middle == Approx(0).margin(0.05));  // no bias
  const auto gross =
      std::count_if(errors.begin(), errors.end(), [](double e) { return std::abs(e) > 1; });
  CHECK(gross < static_cast<std::ptrdiff_t>(errors.size() / 20));
}

TEST_CASE("a repeated pattern has no unique match, a single mark has") {
  cv::Mat stripes(60, 200, CV_8U);
  for (int u = 0; u < stripes.cols; ++u) stripes.col(u) = (u / 5) % 2 == 0 ? 60 : 180;
  CHECK(std::isnan(searchRow(stripes, stripes, {150, 30}, 60)));
  cv::Mat left(60, 200, CV_8U, cv::Scalar(100));
  cv::Mat right = left.clone();
  cv::circle(left, {150, 30}, 3, 220, -1);
  cv::circle(right, {127, 30}, 3, 240, -1);  // the other camera is brighter
  CHECK(searchRow(left, right, {150, 30}, 60) == 23);
  CHECK(std::isnan(searchRow(left, right, {1, 30}, 60)));  // the patch would hang over
}
