// SPDX-License-Identifier: BSD-3-Clause
// Axes, shapes, colours and pixels.
#include <catch2/catch.hpp>
#include <limits>
#include <opencv2/imgcodecs.hpp>

#include "report/axes.hpp"
#include "report/svg.hpp"

using namespace tolman::report;
using namespace tolman;

namespace {

/// Rec. 709 weights of the sRGB values: enough for an order.
double brightness(const std::string& colour) {
  const auto part = [&](std::size_t at) { return std::stoi(colour.substr(at, 2), nullptr, 16); };
  return 0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5);
}

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

TEST_CASE("ticks are round numbers within the range") {
  CHECK(ticks({0, 10}, 5) == std::vector<double>{0, 2, 4, 6, 8, 10});
  CHECK(ticks({0, 1}, 4) == std::vector<double>{0, 0.5, 1});
  CHECK(ticks({-7, 12}, 4) == std::vector<double>{-5, 0, 5, 10});
  CHECK(ticks({3, 3}, 4) == std::vector<double>{3});
}

TEST_CASE("ticks of any range: some, none outside, equally far apart") {
  for (const double length : {1e-6, 0.37, 1.0, 12.5, 99.0, 1e5}) {
    for (const double low : {-1e3, 0.0, 0.123}) {
      const Range range{low, low + length};
      const auto values = ticks(range, 5);
      REQUIRE(values.size() >= 2);
      CHECK(values.size() <= 13);
      for (const double value : values) {
        CHECK(value >= range.low - 1e-6 * length);
        CHECK(value <= range.high + 1e-6 * length);
      }
    }
  }
}

TEST_CASE("texts of ticks are as short as the step allows") {
  CHECK(tickText(0.25, 0.25) == "0.2");  // a step of 0.25 never comes: 1, 2 and 5 do
  CHECK(tickText(1500, 500) == "1500");
  CHECK(tickText(0.002, 0.001) == "0.002");
  CHECK(tickText(-1e-18, 0.5) == "0.0");  // no "-0"
  CHECK(tickText(3, std::numeric_limits<double>::infinity()) == "0");
  CHECK(tickText(0, 1e-300) == "0.000000000");
}

TEST_CASE("values come to the right pixels") {
  Svg svg(200, 200);
  const Axes axes(svg, {"", "x", "y", {0, 10}, {-1, 1}, frame(50, 20, 150, 120)});
  CHECK(axes.at(0, -1).isApprox(Eigen::Vector2d(50, 120)));
  CHECK(axes.at(10, 1).isApprox(Eigen::Vector2d(150, 20)));
  CHECK(axes.at(5, 0).isApprox(Eigen::Vector2d(100, 70)));
  CHECK(axes.pixelsX(1) == Approx(10));
}

TEST_CASE("equal axes have one scale, and the frame shrinks to it") {
  Svg svg(400, 400);
  AxesPlan plan{"", "x", "y", {0, 10}, {0, 5}, frame(0, 0, 300, 300)};
  plan.equal = true;
  const Axes axes(svg, plan);
  CHECK((axes.at(1, 1) - axes.at(0, 0)).isApprox(axes.pixelsX(1) * Eigen::Vector2d(1, -1)));
  CHECK(axes.box().sizes().isApprox(Eigen::Vector2d(300, 150)));
}

TEST_CASE("lines do not leave the frame, and a range of nothing is no division by zero") {
  Svg svg(200, 200);
  Axes axes(svg, {"", "x", "y", {0, 0}, {0, 1}, frame(50, 20, 150, 120)});
  axes.polyline({0, 1}, {-100, 100}, kBlue);
  const std::string text = svg.take();
  CHECK(text.find("points=\"50.0,120.0 150.0,20.0 \"") != std::string::npos);
  CHECK(text.find("nan") == std::string::npos);
  CHECK(text.find("inf") == std::string::npos);
}

TEST_CASE("names from a configuration cannot become markup") {
  CHECK(escaped("<script>\"a\" & b</script>") ==
        "&lt;script&gt;&quot;a&quot; &amp; b&lt;/script&gt;");
  Svg svg(10, 10);
  svg.text({1, 2}, "</text><script>");
  const std::string text = svg.take();
  CHECK(text.find("<script>") == std::string::npos);
  CHECK(text.find("&lt;/text&gt;&lt;script&gt;") != std::string::npos);
}

TEST_CASE("control characters and damaged UTF-8 are replaced: XML forbids them") {
  CHECK(escaped("a\033[31m\xff\n") == "a\xef\xbf\xbd[31m\xef\xbf\xbd\n");
}

TEST_CASE("a picture says its size and draws what it is told") {
  Svg svg(120, 80);
  svg.line({1, 2}, {3, 4}, kBlue, 2);
  svg.circle({5, 6}, 3, kGreen);
  svg.rectangle({7, 8}, {9, 10}, "none", kGrey);
  svg.text({1, 1}, "up", {TextAnchor::End, 10, -90, true});
  const std::string text = svg.take();
  CHECK(text.find("width=\"120\" height=\"80\"") != std::string::npos);
  CHECK(text.find("<line x1=\"1.0\" y1=\"2.0\" x2=\"3.0\" y2=\"4.0\"") != std::string::npos);
  CHECK(text.find("<circle cx=\"5.0\" cy=\"6.0\" r=\"3\" fill=\"#009E73\"") != std::string::npos);
  CHECK(text.find("rotate(-90 1.0 1.0)") != std::string::npos);
  CHECK(text.ends_with("</svg>\n"));
}

TEST_CASE("the ends are the published ones, and what is outside takes them") {
  CHECK(rateColour(0) == "#440154");
  CHECK(rateColour(1) == "#fde725");
  CHECK(rateColour(-3) == rateColour(0));
  CHECK(rateColour(7) == rateColour(1));
  CHECK(rateColour(std::numeric_limits<double>::quiet_NaN()) == rateColour(0));
}

TEST_CASE("more is brighter, without exception: the map works in grey too") {
  for (int i = 0; i < 100; ++i) {
    CHECK(brightness(rateColour(i / 100.0)) < brightness(rateColour((i + 1) / 100.0)));
  }
}

TEST_CASE("a colour bar runs from dark to bright, between its labels") {
  Svg svg(200, 20);
  colourBar(svg, {100, 10}, "none", "most");
  const std::string text = svg.take();
  const auto place = [&](const std::string& part) { return text.find(part); };
  CHECK(place(rateColour(0)) < place(rateColour(1)));
  CHECK(place("none") != std::string::npos);
  CHECK(place("most") != std::string::npos);
}

TEST_CASE("rates become pixels: right is right, up is up, unknown is transparent") {
  Eigen::MatrixXd rates(2, 3);  // right, up
  rates << 0, NAN, 2, 0, 1, 0;
  const Pixels pixels = ratePixels(rates, 2);
  REQUIRE((pixels.rows() == 3 && pixels.cols() == 2));
  CHECK(pixels(2, 0) == 0xff440154);
  CHECK(pixels(1, 0) == 0);
  CHECK(pixels(0, 0) == 0xfffde725);
  CHECK(pixels(1, 1) == 0xff21908d);
}

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
