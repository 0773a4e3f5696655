// SPDX-License-Identifier: BSD-3-Clause
// Disparities and landmarks of scenes whose geometry is known.
#include "landmarks.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "support/gray_images.hpp"
#include "support/street_scene.hpp"
#include "tolman/image_cv.hpp"

using namespace tolman;
using namespace tolman::landmarks;
using namespace tolman::test;

namespace {

double texture(double x, double y) {
  return 120 + 30 * std::sin(0.45 * x + 0.2 * y) + 25 * std::sin(0.23 * x - 0.5 * y) +
         20 * std::sin(0.013 * x * x / 3 + 0.3 * y);
}

/// Share by which a point is away from the nearest plane of the street: ground, walls, end.
double awayFromStreet(const cv::Point3f& p) {
  return std::min({std::abs(p.y / 1.5 - 1), std::abs(p.x / -5.0 - 1), std::abs(p.x / 6.0 - 1),
                   std::abs(p.z / 60.0 - 1)});
}

}  // namespace

TEST_CASE("disparity is found to a tenth of a pixel, and refused where nothing is alike") {
  const Image left = gray(200, 60, [](int x, int y) { return texture(x, y); });
  for (const double disparity : {3.0, 7.4, 21.75}) {
    const Image right = gray(200, 60, [&](int x, int y) { return texture(x + disparity, y); });
    for (const float x : {60.0F, 101.0F, 150.0F}) {
      CHECK(disparityAt(asMat(left), asMat(right), {x, 30}, 40) == Approx(disparity).margin(0.15));
    }
    CHECK(disparityAt(asMat(left), asMat(right), {100, 2}, 40) < 0);  // too near to the border
  }
  RandomStream random(4);
  CHECK(disparityAt(asMat(left), asMat(noise(200, 60, random)), {100, 30}, 40) < 0);
  const auto fence = [](int x, int) { return x % 8 < 3 ? 200 : 60; };
  CHECK(disparityAt(asMat(gray(200, 60, fence)), asMat(gray(200, 60, fence)), {100, 30}, 40) < 0);
}

TEST_CASE("landmarks of a street lie on its ground and walls") {
  const CameraRig rig = streetRig();
  const Frame frame = streetFrame(0, Eigen::Isometry3d::Identity());
  const Corners corners = findCorners(asMat(frame.left), 400);
  REQUIRE(corners.pixels.size() > 100);
  REQUIRE(corners.pixels.size() <= 400);
  REQUIRE(corners.descriptions.rows == static_cast<int>(corners.pixels.size()));
  REQUIRE(corners.descriptions.cols == kDescriptionBytes);
  const Landmarks found = findLandmarks(asMat(frame.left), asMat(frame.right), rig, corners);
  REQUIRE(found.points.size() > 50);
  REQUIRE(found.descriptions.rows == static_cast<int>(found.points.size()));
  // Depth is worth a third of a pixel of disparity, which is 150 / z px.
  const auto near = std::ranges::count_if(
      found.points, [](const cv::Point3f& p) { return awayFromStreet(p) < 0.02 + p.z / 450; });
  CHECK(static_cast<double>(near) > 0.9 * static_cast<double>(found.points.size()));
}

TEST_CASE("corners are the same each time, and grey is the picture itself") {
  const Image picture = streetFrame(0, Eigen::Isometry3d::Identity()).left;
  const Corners a = findCorners(asMat(picture), 200);
  const Corners b = findCorners(grayOf(coloured(picture)), 200);
  CHECK(a.pixels == b.pixels);
  CHECK(std::equal(a.descriptions.datastart, a.descriptions.dataend, b.descriptions.datastart));
  CHECK(grayOf(picture).data == picture.row(0));  // not a copy
}

TEST_CASE("corners of wide images are those of the reduced image") {
  const Image picture = streetFrame(0, Eigen::Isometry3d::Identity()).left;
  cv::Mat narrow;
  cv::resize(asMat(picture), narrow, cv::Size(600, 200), 0, 0, cv::INTER_AREA);
  cv::Mat wide;  // each pixel three times, and a column and a row that are left over
  cv::resize(narrow, wide, cv::Size(1800, 600), 0, 0, cv::INTER_NEAREST);
  cv::copyMakeBorder(wide, wide, 0, 1, 0, 1, cv::BORDER_REPLICATE);
  const Corners of_narrow = findCorners(narrow, 200);
  const Corners of_wide = findCorners(wide, 200);
  REQUIRE(of_wide.pixels.size() == of_narrow.pixels.size());
  for (std::size_t i = 0; i < of_wide.pixels.size(); ++i) {
    const cv::Point2f centre = 3 * of_narrow.pixels[i] + cv::Point2f(1, 1);
    CHECK(cv::norm(of_wide.pixels[i] - centre) < 1e-3);
  }
  CHECK(of_narrow.sigma == 1);
  CHECK(of_wide.sigma == 3);
}

TEST_CASE("a picture without corners has no landmarks") {
  const Corners none = findCorners(asMat(filled(90)), 200);
  CHECK(none.pixels.empty());
  const Landmarks found = findLandmarks(asMat(filled(90)), asMat(filled(90)), streetRig(), none);
  CHECK(found.points.empty());
}
