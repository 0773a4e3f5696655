// SPDX-License-Identifier: BSD-3-Clause
// The measured misalignment of scenes whose misalignment is known.
#include "engine/stereo_check.hpp"

#include <catch2/catch.hpp>

#include "imaging/painted_pair.hpp"

using namespace tolman;
using namespace tolman::imaging;
using test::PaintedPair;

namespace {

StereoMeasure measureOf(const PaintedPair& pair) {
  return measureStereo(grayHalf(pair.left()), grayHalf(pair.right()));
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
  CHECK(faultText(StereoFault::Exchanged, measure) == "left and right image are exchanged");
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
  const StereoMeasure measure = measureStereo(grayHalf(pair.left()), grayHalf(other.right()));
  CHECK(measure.matched < 8);
  CHECK(faultOf(measure) == StereoFault::None);
  const auto flat = grayHalf(Image::create(640, 200, PixelFormat::Gray8, [](std::uint8_t*) {}));
  CHECK(measureStereo(flat, flat).corners == 0);
  const auto tiny = grayHalf(Image::create(8, 8, PixelFormat::Gray8, [](std::uint8_t*) {}));
  CHECK(measureStereo(tiny, tiny).corners == 0);
  CHECK(measureStereo(flat, tiny).corners == 0);
}

TEST_CASE("the text says how far, in which direction, and what to ask") {
  StereoMeasure measure;
  measure.matched = 30;
  measure.rows_low = 3.04;
  CHECK(faultText(StereoFault::RowsApart, measure) ==
        "the right image is 3.0 px low; are the images rectified?");
  measure.rows_low = -2;
  CHECK(faultText(StereoFault::RowsApart, measure) ==
        "the right image is 2.0 px high; are the images rectified?");
  CHECK(faultText(StereoFault::None, measure).empty());
}
