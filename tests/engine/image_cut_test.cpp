// SPDX-License-Identifier: BSD-3-Clause
// Cropped and scaled images against OpenCV's area means; calibration against projected points.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <opencv2/imgproc.hpp>

#include "engine/pixel_map.hpp"
#include "tolman/image_cv.hpp"

using namespace tolman;
using engine::ImageCut;

namespace {

CameraRig stereoRig(int width, int height) {
  CameraRig rig;
  rig.width = width;
  rig.height = height;
  rig.calibrated = true;
  rig.pinhole = {700, 690, 310.5, 120.25};
  rig.baseline = 0.5;
  return rig;
}

/// Noise and a slope, so that each pixel has its own value.
Image painted(int width, int height, PixelFormat format) {
  return Image::create(width, height, format, [&](std::uint8_t* pixels) {
    std::uint32_t state = 1;
    for (int i = 0; i < width * height * bytesPerPixel(format); ++i) {
      state = state * 1664525U + 1013904223U;
      pixels[i] = static_cast<std::uint8_t>((state >> 26U) + static_cast<std::uint32_t>(i % 180));
    }
  });
}

ImageCut cutOf(const CameraRig& rig, const std::vector<double>& crop, double scale) {
  Result<ImageCut> cut = ImageCut::create(rig, crop, scale);
  REQUIRE(cut.isOk());
  return std::move(cut).value();
}

cv::Mat viewed(const Image& image) {
  const int type = image.format() == PixelFormat::Gray8 ? CV_8UC1 : CV_8UC3;
  return {image.height(), image.width(), type, const_cast<std::uint8_t*>(image.data()),
          static_cast<std::size_t>(image.stride())};
}

}  // namespace

TEST_CASE("without crop and scale nothing is changed") {
  const CameraRig rig = stereoRig(640, 240);
  const ImageCut cut = cutOf(rig, {}, 1);
  CHECK(cut.isWhole());
  CHECK(cut.text().empty());
  const Image image = painted(640, 240, PixelFormat::Gray8);
  CHECK(cut.apply(image).data() == image.data());
  CHECK(ImageCut().apply(image).data() == image.data());
}

TEST_CASE("a part shows its pixels without a copy of them") {
  const CameraRig rig = stereoRig(640, 240);
  const ImageCut cut = cutOf(rig, {17, 5, 600, 200}, 1);
  for (const PixelFormat format : {PixelFormat::Gray8, PixelFormat::Bgr8}) {
    const Image image = painted(640, 240, format);
    const Image part = cut.apply(image);
    CHECK(part.width() == 600);
    CHECK(part.height() == 200);
    CHECK(part.row(3) == image.row(8) + std::ptrdiff_t{17} * bytesPerPixel(format));
    CHECK(part.owner() == image.owner());
  }
  CHECK(cut.text() == "600x200 px at (17, 5) of 640x240 px");
  CHECK(cut.apply(Image()).empty());
}

TEST_CASE("scaled pixels are the means of the areas that they cover") {
  const CameraRig rig = stereoRig(641, 243);
  for (const double scale : {0.5, 0.37, 0.8, 0.15}) {
    const ImageCut cut = cutOf(rig, {10, 3, 602, 221}, scale);
    for (const PixelFormat format : {PixelFormat::Gray8, PixelFormat::Bgr8}) {
      const Image image = painted(641, 243, format);
      const Image scaled = cut.apply(image);
      REQUIRE(scaled.width() == cut.rig().width);
      cv::Mat wanted;
      cv::resize(viewed(image)(cv::Rect(10, 3, 602, 221)), wanted,
                 {cut.rig().width, cut.rig().height}, 0, 0, cv::INTER_AREA);
      CHECK(cv::norm(viewed(scaled), wanted, cv::NORM_INF) <= 1);
    }
  }
}

TEST_CASE("an even grey stays what it is, to the last bit") {
  const ImageCut cut = cutOf(stereoRig(321, 77), {}, 0.613);
  for (const int level : {0, 1, 127, 254, 255}) {
    const Image image = Image::create(321, 77, PixelFormat::Gray8, [&](std::uint8_t* pixels) {
      std::fill_n(pixels, 321 * 77, static_cast<std::uint8_t>(level));
    });
    const cv::Mat scaled = viewed(cut.apply(image)).clone();
    CHECK(cv::countNonZero(scaled != level) == 0);
  }
}

TEST_CASE("the calibration follows: a point is seen at the same place of the scene") {
  const CameraRig rig = stereoRig(640, 240);
  const ImageCut cut = cutOf(rig, {100, 20, 500, 201}, 0.41);
  const CameraRig& made = cut.rig();
  const double across = 500.0 / made.width;
  const double down = 201.0 / made.height;
  for (const Eigen::Vector3d& point :
       {Eigen::Vector3d(0.1, -0.2, 3), Eigen::Vector3d(-1, 0.4, 9)}) {
    const Eigen::Vector2d old = rig.pinhole.project(point);
    const Eigen::Vector2d now = made.pinhole.project(point);
    // The border of an image is half a pixel before the centre of its first pixel.
    CHECK((now.x() + 0.5) * across == Approx(old.x() - 100 + 0.5).margin(1e-9));
    CHECK((now.y() + 0.5) * down == Approx(old.y() - 20 + 0.5).margin(1e-9));
  }
  CHECK(made.baseline == rig.baseline);
  CHECK(cut.text() == "500x201 px at (100, 20) of 640x240 px, scaled to 205x82 px");
}

TEST_CASE("values of pixels follow, those of other shapes stay") {
  const ImageCut cut = cutOf(stereoRig(96, 80), {8, 16, 64, 64}, 0.5);
  NamedArray depth{"depth", {80, 96}, {}};
  for (int i = 0; i < 80 * 96; ++i) depth.values.push_back(static_cast<float>(i));
  NamedArray rate{"gyroscope", {3}, {1, 2, 3}};
  cut.apply(depth);
  cut.apply(rate);
  CHECK(depth.shape == std::vector<int>{32, 32});
  REQUIRE(depth.values.size() == 32 * 32);
  CHECK(depth.values[0] == 17 * 96 + 9);  // one of the four pixels that the first one covers
  CHECK(depth.values[33] == 19 * 96 + 11);
  CHECK(rate.shape == std::vector<int>{3});
}

TEST_CASE("what cannot be is refused with the remedy") {
  const CameraRig rig = stereoRig(640, 240);
  const auto problem = [](const CameraRig& of, const std::vector<double>& crop, double scale) {
    const Status status = ImageCut::create(of, crop, scale).status();
    CHECK(status.code() == StatusCode::InvalidParameter);
    return status.message();
  };
  CHECK_THAT(problem(rig, {0, 0, 641, 240}, 1),
             Catch::Contains("not inside of the images; the images have 640x240 px"));
  CHECK_THAT(problem(rig, {0, 0, 31, 240}, 1), Catch::Contains("at least 32 px"));
  CHECK_THAT(problem(rig, {0, 0, 100}, 1), Catch::Contains("has 3 numbers"));
  CHECK_THAT(problem(rig, {0.5, 0, 100, 100}, 1), Catch::Contains("fractions"));
  CHECK_THAT(problem(rig, {}, 0.1), Catch::Contains("64x24 px of 640x240"));
  CHECK_THAT(problem(CameraRig(), {}, 0.5), Catch::Contains("gives no images"));
}
