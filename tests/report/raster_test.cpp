// SPDX-License-Identifier: BSD-3-Clause
#include "report/raster.hpp"

#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>

#include "report/svg.hpp"

using namespace tolman;
using namespace tolman::report;

namespace {

/// OpenCV is the judge: it has nothing to do with how the picture was made.
cv::Mat decoded(const std::string& png) {
  return cv::imdecode(std::vector<uchar>(png.begin(), png.end()), cv::IMREAD_COLOR);
}

int darkPixels(const cv::Mat& image, const cv::Rect& where) {
  int dark = 0;
  for (int y = where.y; y < where.br().y; ++y) {
    for (int x = where.x; x < where.br().x; ++x) dark += image.at<cv::Vec3b>(y, x)[1] < 128;
  }
  return dark;
}

}  // namespace

TEST_CASE("a picture becomes pixels of the same colours at the same places") {
  Svg svg(100, 60);
  svg.rectangle({20, 10}, {30, 40}, kBlue);
  const auto png = pngOf(svg.take(), 2);
  REQUIRE(png.isOk());
  const cv::Mat image = decoded(png.value());
  REQUIRE(image.size() == cv::Size(200, 120));
  CHECK(image.at<cv::Vec3b>(60, 70) == cv::Vec3b(0xB2, 0x72, 0x00));  // #0072B2, read as BGR
  CHECK(image.at<cv::Vec3b>(60, 30) == cv::Vec3b(255, 255, 255));
  CHECK(image.at<cv::Vec3b>(110, 70) == cv::Vec3b(255, 255, 255));
}

TEST_CASE("text is drawn: a font is there") {
  Svg svg(100, 30);
  svg.text({5, 20}, "0.25 m");
  const auto png = pngOf(svg.take(), 1);
  REQUIRE(png.isOk());
  CHECK(darkPixels(decoded(png.value()), {5, 8, 60, 14}) > 20);
  CHECK(darkPixels(decoded(png.value()), {60, 0, 40, 30}) == 0);
}

TEST_CASE("pixels within a picture keep their places and colours, and need no other file") {
  Pixels pixels = Pixels::Constant(2, 3, 0xffffffff);
  pixels(0, 2) = 0xffd55e00;  // above, to the right
  Svg svg(30, 20);
  svg.image({0, 0}, {30, 20}, pngUrl(pixels));
  CHECK(svg.take().find("href=\"data:image/png;base64,") != std::string::npos);
  const auto png = pngOf(svg.take(), 1);
  REQUIRE(png.isOk());
  const cv::Mat image = decoded(png.value());
  CHECK(image.at<cv::Vec3b>(2, 28) == cv::Vec3b(0x00, 0x5e, 0xd5));
  CHECK(image.at<cv::Vec3b>(17, 28) == cv::Vec3b(255, 255, 255));
  CHECK(image.at<cv::Vec3b>(2, 5) == cv::Vec3b(255, 255, 255));
}

TEST_CASE("what is no picture, or too large a one, is an error") {
  CHECK_FALSE(pngOf("").isOk());
  CHECK_FALSE(pngOf("<html></html>").isOk());
  CHECK_FALSE(pngOf(Svg(1e9, 10).take()).isOk());
  CHECK_FALSE(pngOf(Svg(0, 0).take()).isOk());
}

TEST_CASE("a figure as PDF: one page of its size, the same bytes each time") {
  Svg svg(360, 270);
  svg.text({20, 20}, "error (m)");
  const auto pdf = pdfOf(svg.take());
  REQUIRE(pdf.isOk());
  CHECK(pdf.value().starts_with("%PDF-"));
  CHECK(pdf.value().find("MediaBox [ 0 0 252 189 ]") != std::string::npos);  // 88.9 mm wide
  CHECK(pdf.value().find("/Subtype /Image") == std::string::npos);
  CHECK(pdf.value().find("CreationDate") == std::string::npos);
  CHECK(pdfOf(svg.take()).value() == pdf.value());
  CHECK_FALSE(pdfOf("").isOk());
}
