// SPDX-License-Identifier: BSD-3-Clause
// Rectification of real recordings: official geometry, and rows of matched corners.
#include <catch2/catch.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "engine/camera_check.hpp"
#include "engine/pixel_map.hpp"
#include "engine/rectified_view.hpp"
#include "layouts.hpp"
#include "support/context.hpp"
#include "support/data.hpp"
#include "tolman/image_cv.hpp"

using namespace tolman;
using namespace tolman::engine;
using EurocSource = image_folders::LayoutSource<image_folders::EurocParameters>;
using KittiRawSource = image_folders::LayoutSource<image_folders::KittiRawParameters>;

namespace {

/// Rectified pairs of a raw source.
struct Rectified {
  Rectified(image_folders::FolderSource& source, ParameterValues values) {
    test::TestContext context(std::move(values));
    const Status ready = source.configure(context);
    INFO(ready.message());
    REQUIRE(ready.isOk());
    REQUIRE(source.rawRig(raw).isOk());
    view = chooseView(raw, {}).value();
    for (std::size_t i = 0; i < 2; ++i) {
      maps.emplace_back(raw.cameras[i], view.R_rectified_raw[i], view.rig);
    }
    for (Frame frame; source.next(frame).isOk(); frame = {}) {
      frame.left = maps[0].apply(frame.left);
      frame.right = maps[1].apply(frame.right);
      frames.push_back(frame);
    }
  }
  RawRig raw;
  RectifiedView view;
  std::vector<PixelMap> maps;
  std::vector<Frame> frames;
};

/// Median over the frames of the median difference in rows, px; and corners that were matched.
std::pair<double, int> rowsApart(const std::vector<Frame>& frames) {
  std::vector<double> rows;
  int matched = 0;
  for (const Frame& frame : frames) {
    const StereoMeasure measure = measureStereo(halfOf(frame.left), halfOf(frame.right));
    CHECK(measure.spread < 2);
    CHECK(measure.share_exchanged < 0.1);
    rows.push_back(measure.rows_low);
    matched += measure.matched;
  }
  std::nth_element(rows.begin(), rows.begin() + std::ssize(rows) / 2, rows.end());
  return {rows[rows.size() / 2], matched};
}

/// Where OpenCV projects a point of the first camera's frame into a raw camera.
cv::Point2d rawPixel(const RawCamera& camera, const RawCamera& first,
                     const Eigen::Vector3d& point) {
  const Eigen::Vector3d p =
      camera.T_reference_camera.inverse() * (first.T_reference_camera * point);
  const Pinhole& K = camera.pinhole;
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(std::vector<cv::Point3d>{{p.x(), p.y(), p.z()}}, cv::Vec3d(0, 0, 0),
                    cv::Vec3d(0, 0, 0), cv::Matx33d(K.fx, 0, K.cx, 0, K.fy, K.cy, 0, 0, 1),
                    std::vector<double>(camera.distortion.data(), camera.distortion.data() + 8),
                    pixels);
  return pixels[0];
}

/// A bright spot on black.
Image spotAt(const cv::Point2d& centre, int width, int height) {
  return Image::create(width, height, PixelFormat::Gray8, [&](std::uint8_t* pixel) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const double d = std::pow(x - centre.x, 2) + std::pow(y - centre.y, 2);
        *pixel++ = static_cast<std::uint8_t>(std::lround(250 * std::exp(-d / 8)));
      }
    }
  });
}

cv::Point2d centreOf(const Image& image) {
  const cv::Moments moments = cv::moments(asMat(image));
  return {moments.m10 / moments.m00, moments.m01 / moments.m00};
}

}  // namespace

TEST_CASE("KITTI's raw images come out in the official geometry, to a tenth of a pixel", "[data]") {
  const auto path = test::dataOrSkip("kitti_raw_unrectified");
  if (!path) return;
  KittiRawSource source;
  const Rectified rectified(source, {{"path", path->string()}, {"rate", 10.0}});
  CHECK(rectified.frames.size() == 6);
  CHECK(rectified.view.rig.width == 1242);
  CHECK(rectified.view.rig.height == 375);
  const RawRig& raw = rectified.raw;
  const Pinhole official{721.5377, 721.5377, 609.5593, 172.8540};  // P_rect_00
  for (const double depth : {8.0, 40.0}) {
    for (int u = 100; u < 1200; u += 270) {
      for (int v = 40; v < 350; v += 100) {
        // P_rect_0i R_rect_00 X, as KITTI's development kit defines it.
        const Eigen::Vector3d in_rectified = depth * official.ray({u, v});
        const Eigen::Vector3d X = raw.cameras[0].R_rectified_camera.transpose() * in_rectified;
        const double disparity = 387.5744 / depth;
        for (std::size_t i = 0; i < 2; ++i) {
          const cv::Point2d at = rawPixel(raw.cameras[i], raw.cameras[0], X);
          const cv::Point2d expected(u - (i == 1 ? disparity : 0), v);
          if (expected.x < 30) continue;
          const cv::Point2d found = centreOf(rectified.maps[i].apply(spotAt(at, 1392, 512)));
          CAPTURE(i, depth, u, v);
          CHECK(cv::norm(found - expected) < 0.1);
        }
      }
    }
  }
  const auto [rows, matched] = rowsApart(rectified.frames);
  CHECK(std::abs(rows) < 0.3);  // the resolution of the measure
  CAPTURE(matched);
  CHECK(matched > 60);
}

TEST_CASE("EuRoC's pairs have their corners in one row after rectification", "[data]") {
  const auto path = test::dataOrSkip("euroc_v101");
  if (!path) return;
  EurocSource source;
  const Rectified rectified(source, {{"path", path->string()}});
  const auto [rows, matched] = rowsApart(rectified.frames);
  CHECK(std::abs(rows) < 0.5);
  CHECK(matched > 100);
  CHECK(rectified.view.rig.baseline == Approx(0.110).margin(0.001));
}

TEST_CASE("TUM-VI's fisheye pairs have their corners in one row after rectification", "[data]") {
  const auto path = test::dataOrSkip("tumvi_room1");
  if (!path) return;
  EurocSource source;
  const Rectified rectified(source, {{"path", path->string()}});
  const auto [rows, matched] = rowsApart(rectified.frames);
  CHECK(std::abs(rows) < 0.5);
  CHECK(matched > 30);
}
