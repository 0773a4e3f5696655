// SPDX-License-Identifier: BSD-3-Clause
// Rectified images against OpenCV's maps and cv::remap.
#include "engine/pixel_map.hpp"

#include <oneapi/tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "engine/raw_cameras.hpp"
#include "engine/rectified_view.hpp"
#include "support/gray_images.hpp"
#include "tolman/image_cv.hpp"

using namespace tolman;
using namespace tolman::engine;

namespace {

/// A picture with edges and slopes.
Image picture(const RawCamera& camera) {
  return test::gray(camera.width, camera.height, [](int x, int y) {
    return 120 + 80 * std::sin(x / 9.0) * std::cos(y / 13.0) + (x / 40 + y / 40) % 2 * 30;
  });
}

/// The rectified image by OpenCV.
cv::Mat byOpenCv(const RawCamera& camera, const Eigen::Matrix3d& R, const CameraRig& rig,
                 const Image& image) {
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = R;
  const cv::Matx33d turn(rows.data());
  const cv::Size size(rig.width, rig.height);
  cv::Mat x;
  cv::Mat y;
  const double* k = camera.distortion.data();
  if (camera.model == LensModel::Equidistant) {
    cv::fisheye::initUndistortRectifyMap(test::matrixOf(camera.pinhole),
                                         std::vector<double>(k, k + 4), turn,
                                         test::matrixOf(rig.pinhole), size, CV_32FC1, x, y);
  } else {
    cv::initUndistortRectifyMap(test::matrixOf(camera.pinhole), std::vector<double>(k, k + 8), turn,
                                test::matrixOf(rig.pinhole), size, CV_32FC1, x, y);
  }
  cv::Mat out;
  cv::remap(asMat(image), out, x, y, cv::INTER_LINEAR, cv::BORDER_CONSTANT, 0);
  return out;
}

}  // namespace

TEST_CASE("rectified images are those of OpenCV's maps") {
  const RawCamera camera =
      GENERATE(test::eurocCamera(), test::fisheyeCamera(), test::rationalCamera());
  const RawRig rig = test::pairOf(camera, 0.1, {0.02, -0.03, 0.01});
  const auto view = chooseView(rig, {});
  REQUIRE(view.isOk());
  const Image raw = picture(camera);
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Matrix3d& R = view.value().R_rectified_raw[i];
    const Image mine = PixelMap(camera, R, view.value().rig).apply(raw);
    const cv::Mat theirs = byOpenCv(camera, R, view.value().rig, raw);
    cv::Mat difference;
    cv::absdiff(asMat(mine), theirs, difference);
    double most = 0;
    cv::minMaxLoc(difference, nullptr, &most);
    CHECK(most <= 3);  // OpenCV interpolates in steps of 1/32 px; the steepest slope is 30 a px
    CHECK(cv::mean(difference)[0] < 0.15);
  }
}

TEST_CASE("the bytes do not depend on the number of threads, and colour is rectified alike") {
  const RawCamera camera = test::eurocCamera();
  RawRig rig;
  rig.cameras = {camera};
  const CameraRig rectified = chooseView(rig, {}).value().rig;
  const Image raw = picture(camera);
  Image first;
  for (const std::size_t threads : {1, 2, 5}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const PixelMap map(camera, Eigen::Matrix3d::Identity(), rectified);
    const Image image = map.apply(raw);
    if (first.empty()) first = image;
    const auto bytes = static_cast<std::size_t>(rectified.width * rectified.height);
    CHECK(std::memcmp(first.data(), image.data(), bytes) == 0);
    const Image colour = map.apply(test::coloured(raw));
    REQUIRE(colour.format() == PixelFormat::Bgr8);
    CHECK(cv::norm(asMat(test::coloured(image)), asMat(colour), cv::NORM_INF) == 0);
  }
}

TEST_CASE("each pixel is the mean of four by the shares of its position") {
  const RawCamera camera =
      GENERATE(test::eurocCamera(), test::fisheyeCamera(), test::rationalCamera());
  const double turn = GENERATE(0.0, 0.3, 1.5707963267948966, 3.1);
  const double scale = GENERATE(0.4, 1.0, 2.5);
  CameraRig rig{333, 211, true, {}, 0};
  const double f = scale * camera.pinhole.fx;
  rig.pinhole = {f, f, 170, 100};
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(turn, Eigen::Vector3d(0.1, 0.05, 1).normalized()).toRotationMatrix();
  const Image raw = test::gray(camera.width, camera.height,
                               [](int x, int y) { return (x * 7919 + y * 104729) % 256; });
  const Lens lens(camera);
  cv::Mat expected = cv::Mat::zeros(rig.height, rig.width, CV_8U);
  for (int y = 0; y < rig.height; ++y) {
    for (int x = 0; x < rig.width; ++x) {
      const auto at = lens.pixelOf(R.transpose() * rig.pinhole.ray({x, y}));
      if (!at) continue;
      const double u = std::round(32 * at->x()) / 32;
      const double v = std::round(32 * at->y()) / 32;
      const int column = std::min(static_cast<int>(u), camera.width - 2);
      const int row = std::min(static_cast<int>(v), camera.height - 2);
      const auto across = [&](const std::uint8_t* p) {
        return std::lerp(p[column], p[column + 1], u - column);
      };
      expected.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(
          std::lerp(across(raw.row(row)), across(raw.row(row + 1)), v - row));
    }
  }
  cv::Mat difference;
  cv::absdiff(asMat(PixelMap(camera, R, rig).apply(raw)), expected, difference);
  // A position between two steps of 1/32 px may be rounded to either of them: floats hold it.
  CHECK(cv::countNonZero(difference > 1) < 2e-3 * static_cast<double>(difference.total()));
  CHECK(cv::norm(difference, cv::NORM_INF) < 17);
  CHECK(cv::mean(expected)[0] > 1);
}

TEST_CASE("a raw image with gaps between its rows is read by its stride") {
  const RawCamera camera = test::eurocCamera();
  const CameraRig rig{camera.width, camera.height, true, camera.pinhole, 0};
  const PixelMap map(camera, Eigen::Matrix3d::Identity(), rig);
  const Image raw = picture(camera);
  cv::Mat wider(raw.height(), raw.width() + 37, CV_8UC1, cv::Scalar(255));
  asMat(raw).copyTo(wider.colRange(0, raw.width()));
  const Image same(wider.data, raw.width(), raw.height(), raw.width() + 37, PixelFormat::Gray8,
                   nullptr);
  CHECK(cv::norm(asMat(map.apply(raw)), asMat(map.apply(same)), cv::NORM_INF) == 0);
}

TEST_CASE("depth goes the way of the image, by its nearest value") {
  const RawCamera camera = test::rawCamera(LensModel::Pinhole, 64, 48, {50, 50, 31.5, 23.5}, {});
  const PixelMap map(camera, Eigen::Matrix3d::Identity(),
                     CameraRig{80, 48, true, {50, 50, 39.3, 23.5}, 0});
  NamedArray depth{"depth", {48, 64}, {}};
  for (int i = 0; i < 48 * 64; ++i) depth.values.push_back(static_cast<float>(i % 64 + 1));
  map.apply(depth);
  REQUIRE(depth.shape == std::vector<int>{48, 80});
  CHECK(depth.values[10 * 80 + 7] == 0);
  CHECK(depth.values[10 * 80 + 20] == 13);  // 20 - 39.3 + 31.5 = 12.2
  NamedArray other{"imu", {3}, {1, 2, 3}};
  map.apply(other);
  CHECK(other.values.size() == 3);
}

TEST_CASE("what the raw image does not show is black; a missing image stays missing") {
  const RawCamera camera = test::rawCamera(LensModel::Pinhole, 64, 48, {50, 50, 31.5, 23.5}, {});
  const CameraRig wide{128, 48, true, {50, 50, 63.5, 23.5}, 0};
  const PixelMap map(camera, Eigen::Matrix3d::Identity(), wide);
  const Image white = test::gray(64, 48, [](int, int) { return 255; });
  CHECK(cv::countNonZero(asMat(map.apply(white))) == 64 * 48);
  const Image raw = test::gray(64, 48, [](int x, int y) { return 50 + x + y; });
  const Image image = map.apply(raw);
  CHECK(image.row(10)[31] == 0);
  CHECK(image.row(10)[32] == 60);   // the first column
  CHECK(image.row(47)[95] == 160);  // the last pixel
  CHECK(image.row(47)[96] == 0);
  CHECK(map.apply(Image()).empty());
  CHECK(map.apply(test::gray(65, 48, [](int, int) { return 1; })).empty());
}
