// SPDX-License-Identifier: BSD-3-Clause
// The measured misalignment of scenes whose misalignment is known.
#include <catch2/catch.hpp>

#include "engine/camera_check.hpp"
#include "engine/painted_pair.hpp"

using namespace tolman;
using namespace tolman::engine;
using test::PaintedPair;

namespace {

StereoMeasure measureOf(const PaintedPair& pair) {
  return measureStereo(halfOf(pair.left()), halfOf(pair.right()));
}

}  // namespace

TEST_CASE("rows that are apart are measured to a fifth of a pixel, with their sign") {
  PaintedPair pair;
  pair.seed = GENERATE(1, 2, 3);
  pair.rows_low = GENERATE(-5.0, -3.0, -1.5, 0.0, 0.5, 2.0, 4.0);
  const StereoMeasure measure = measureOf(pair);
  CAPTURE(pair.seed, pair.rows_low, measure.rows_low, measure.matched, measure.spread);
  CHECK(measure.corners > 40);
  CHECK(measure.matched > 25);
  CHECK(measure.rows_low == Approx(pair.rows_low).margin(0.3));
  CHECK(measure.spread < 1.2);
  CHECK(measure.share_exchanged == 0);
  const bool apart = std::fabs(pair.rows_low) > 1.2;
  CHECK(faultOf(measure) == (apart ? StereoFault::RowsApart : StereoFault::None));
}

TEST_CASE("a sound pair stays sound when one camera is brighter") {
  PaintedPair pair;
  pair.brighter = GENERATE(-25.0, 25.0);
  const StereoMeasure measure = measureOf(pair);
  CHECK(measure.matched > 20);
  CHECK(faultOf(measure) == StereoFault::None);
}

TEST_CASE("exchanged sides are seen by the sign of the disparities") {
  PaintedPair pair;
  pair.exchanged = true;
  pair.seed = GENERATE(4, 5);
  const StereoMeasure measure = measureOf(pair);
  CHECK(measure.share_exchanged > 0.9);
  CHECK(faultOf(measure) == StereoFault::Exchanged);
  CHECK(faultText(StereoFault::Exchanged, measure) ==
        "left and right image are exchanged; exchange the two folders, topics or cameras of the "
        "calibration");
}

TEST_CASE("rows that differ from place to place are of another time") {
  PaintedPair pair;
  pair.scattered = 9;
  const StereoMeasure measure = measureOf(pair);
  CAPTURE(measure.matched, measure.spread);
  CHECK(measure.spread > 3);
  CHECK(faultOf(measure) == StereoFault::OtherTime);
}

TEST_CASE("where nothing can be matched nothing is concluded") {
  PaintedPair pair;
  PaintedPair other;
  other.seed = 77;
  const StereoMeasure measure = measureStereo(halfOf(pair.left()), halfOf(other.right()));
  CHECK(measure.matched < 8);
  CHECK(faultOf(measure) == StereoFault::None);
  const auto flat = halfOf(Image::create(640, 200, PixelFormat::Gray8, [](std::uint8_t*) {}));
  CHECK(measureStereo(flat, flat).corners == 0);
  const auto tiny = halfOf(Image::create(8, 8, PixelFormat::Gray8, [](std::uint8_t*) {}));
  CHECK(measureStereo(tiny, tiny).corners == 0);
  CHECK(measureStereo(flat, tiny).corners == 0);
}

TEST_CASE("the text says how far, in which direction, and what to ask") {
  StereoMeasure measure;
  measure.matched = 30;
  measure.rows_low = 3.04;
  CHECK(faultText(StereoFault::RowsApart, measure) ==
        "the right image is 3.0 px low; are the images rectified, by the calibration of these "
        "cameras?");
  measure.rows_low = -2;
  CHECK(faultText(StereoFault::RowsApart, measure) ==
        "the right image is 2.0 px high; are the images rectified, by the calibration of these "
        "cameras?");
  CHECK(faultText(StereoFault::None, measure).empty());
}

TEST_CASE("each pixel of the half image is the rounded mean of four") {
  const Image image = Image::create(5, 3, PixelFormat::Gray8, [](std::uint8_t* data) {
    for (int i = 0; i < 15; ++i) data[i] = static_cast<std::uint8_t>(10 * i);
  });
  const cv::Mat half = halfOf(image);  // odd columns and rows at the end are left out
  REQUIRE(half.cols == 2);
  REQUIRE(half.rows == 1);
  CHECK(half.at<std::uint8_t>(0, 0) == (0 + 10 + 50 + 60 + 2) / 4);
  CHECK(half.at<std::uint8_t>(0, 1) == (20 + 30 + 70 + 80 + 2) / 4);
}

TEST_CASE("of a colour image green is taken, also where rows are padded") {
  auto pixels = std::make_shared<std::vector<std::uint8_t>>(2 * 16, 255);
  for (int r = 0; r < 2; ++r) {
    for (int c = 0; c < 2; ++c) (*pixels)[static_cast<std::size_t>(r * 16 + 3 * c + 1)] = 40;
  }
  const Image image(pixels->data(), 2, 2, 16, PixelFormat::Bgr8, pixels);
  const cv::Mat half = halfOf(image);
  REQUIRE(half.total() == 1);
  CHECK(half.at<std::uint8_t>(0, 0) == 40);
}

TEST_CASE("an image of one pixel has an empty half") {
  const Image image = Image::create(1, 1, PixelFormat::Gray8, [](std::uint8_t*) {});
  CHECK(halfOf(image).empty());
}
