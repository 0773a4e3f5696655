// SPDX-License-Identifier: BSD-3-Clause
// OpenCV decodes the encoded images to the same pixels.
#include <catch2/catch.hpp>
#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "app/kitti_folder.hpp"
#include "tolman/context.hpp"
#include "tolman/image_cv.hpp"

using namespace tolman;

namespace {

cv::Mat decoded(const Result<std::string>& png, int mode) {
  REQUIRE(png.isOk());
  const std::vector<char> bytes(png.value().begin(), png.value().end());
  return cv::imdecode(bytes, mode);
}

Image noise(int width, int height, PixelFormat format) {
  RandomStream random(3);
  const auto size = static_cast<std::size_t>(width * height * bytesPerPixel(format));
  return Image::create(width, height, format, [&](std::uint8_t* data) {
    for (std::size_t i = 0; i < size; ++i) data[i] = static_cast<std::uint8_t>(random.below(256));
  });
}

void checkPixels(const cv::Mat& ours, const Image& image) {
  REQUIRE(ours.cols == image.width());
  REQUIRE(ours.rows == image.height());
  const auto bytes = static_cast<std::size_t>(image.width() * bytesPerPixel(image.format()));
  for (int r = 0; r < image.height(); ++r)
    CHECK(std::memcmp(ours.ptr(r), image.row(r), bytes) == 0);
}

}  // namespace

TEST_CASE("grey and colour images come back pixel for pixel") {
  const auto format = GENERATE(PixelFormat::Gray8, PixelFormat::Bgr8);
  for (const auto& [width, height] : {std::pair(64, 48), {1241, 37}, {1, 1}, {3, 200}}) {
    const Image image = noise(width, height, format);
    checkPixels(decoded(app::encodePng(image), cv::IMREAD_UNCHANGED), image);
  }
}

TEST_CASE("an image that is part of a wider one is written without its surroundings") {
  const Image wide = noise(100, 20, PixelFormat::Gray8);
  const Image part(wide.data() + 30, 40, 20, wide.stride(), wide.format(), wide.owner());
  checkPixels(decoded(app::encodePng(part), cv::IMREAD_UNCHANGED), part);
}

TEST_CASE("the same image gives the same bytes") {
  const Image image = noise(64, 48, PixelFormat::Gray8);
  CHECK(app::encodePng(image).value() == app::encodePng(image).value());
}

TEST_CASE("depth is metres times 256, and 0 where there is none") {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const NamedArray depth{"depth.left",
                         {2, 5},
                         {0, 1, 2.5F, 0.001F, -3, 255.99F, 256, 1e9F, kInfinity,
                          std::numeric_limits<float>::quiet_NaN()}};
  const cv::Mat pixels = decoded(app::encodeDepthPng(depth), cv::IMREAD_UNCHANGED);
  REQUIRE(pixels.type() == CV_16UC1);
  REQUIRE(pixels.rows == 2);
  const std::vector<int> expected = {0, 256, 640, 0, 0, 65533, 0, 0, 0, 0};
  CHECK(std::vector<int>(pixels.begin<std::uint16_t>(), pixels.end<std::uint16_t>()) == expected);
}

TEST_CASE("an array that is no plane is refused") {
  for (const NamedArray& bad :
       {NamedArray{"depth.left", {10}, std::vector<float>(10)},
        NamedArray{"depth.left", {3, 4}, std::vector<float>(10)},
        NamedArray{"depth.left", {0, 4}, {}}, NamedArray{"depth.left", {-2, -5}, {}}}) {
    const auto png = app::encodeDepthPng(bad);
    REQUIRE_FALSE(png.isOk());
    CHECK(png.status().message() == "'depth.left' has not the shape {height, width}");
  }
}
