// SPDX-License-Identifier: BSD-3-Clause
// The report on pairs with known faults.
#include "engine/pair_survey.hpp"

#include <catch2/catch.hpp>

#include "imaging/painted_pair.hpp"
#include "support/gray_images.hpp"

using namespace tolman;
using namespace tolman::imaging;
using test::PaintedPair;

namespace {

Image mirror(const Image& image) {
  return test::gray(image.width(), image.height(),
                    [&](int x, int y) { return image.row(y)[image.width() - 1 - x]; });
}

std::vector<Finding> findingsOf(PaintedPair pair, bool mirror_left = false,
                                bool mirror_right = false) {
  PairSurvey survey;
  for (const int seed : {1, 2, 3}) {
    pair.seed = seed;
    Frame frame;
    frame.left = mirror_left ? mirror(pair.left()) : pair.left();
    frame.right = mirror_right ? mirror(pair.right()) : pair.right();
    survey.add(frame);
  }
  CHECK(survey.pairs() == 3);
  return survey.findings();
}

}  // namespace

TEST_CASE("sound pairs: the median and the 90 % of rows are noted") {
  const auto found = findingsOf({});
  REQUIRE(found.size() == 1);
  CHECK(found[0].severity == Finding::Severity::Note);
  CHECK_THAT(found[0].message, Catch::Contains("matched in 3 pairs: the right image is 0.") &&
                                   Catch::Contains("90 % of the rows are within"));
}

TEST_CASE("rows apart are told with their sign, and a remedy") {
  PaintedPair pair;
  pair.rows_low = GENERATE(-3.0, 3.0);
  const auto found = findingsOf(pair);
  REQUIRE(found.size() == 2);
  CHECK_THAT(found[0].message, Catch::Contains(pair.rows_low < 0 ? "px high" : "px low"));
  CHECK(found[1].severity == Finding::Severity::Warning);
  CHECK_THAT(found[1].message, Catch::Contains("give the calibration of the raw images"));
}

TEST_CASE("exchanged sides are an error, with a remedy") {
  PaintedPair pair;
  pair.exchanged = true;
  const auto found = findingsOf(pair);
  REQUIRE(found.size() == 2);
  CHECK(found[1].severity == Finding::Severity::Error);
  CHECK_THAT(found[1].message, Catch::Contains("exchange the two folders"));
}

TEST_CASE("a mirrored image is an error, and which one it is") {
  const auto right = findingsOf({}, false, true);
  REQUIRE(right.size() == 1);
  CHECK_THAT(right[0].message, Catch::StartsWith("the right image is mirrored"));
  const auto left = findingsOf({}, true, false);
  REQUIRE(left.size() == 1);
  CHECK_THAT(left[0].message, Catch::StartsWith("the left image is mirrored"));
}

TEST_CASE("rows that differ from place to place are a warning") {
  PaintedPair pair;
  pair.scattered = 8;
  const auto found = findingsOf(pair);
  REQUIRE(found.size() == 2);
  CHECK(found[1].severity == Finding::Severity::Warning);
}

TEST_CASE("without a second image nothing is said, without texture that nothing could be") {
  PairSurvey survey;
  Frame frame;
  frame.left = test::gray(320, 200, [](int, int) { return 90; });
  survey.add(frame);
  CHECK(survey.pairs() == 0);
  CHECK(survey.findings().empty());
  frame.right = frame.left;
  survey.add(frame);
  CHECK(survey.pairs() == 1);
  const std::vector<Finding> found = survey.findings();
  REQUIRE(found.size() == 1);
  CHECK(found[0].severity == Finding::Severity::Warning);
  CHECK(found[0].message.starts_with("only 0 corners matched in 1 pairs"));
}

TEST_CASE("pairs that are nearly black are told as such, not as exchanged") {
  PairSurvey survey;
  Frame frame;
  frame.left = frame.right = test::gray(320, 200, [](int x, int y) { return (x / 5 + y / 5) % 4; });
  survey.add(frame);
  const std::vector<Finding> found = survey.findings();
  REQUIRE(found.size() == 1);
  CHECK(found[0].message.find("nearly black, with hardly any grey level above 3 of 255") !=
        std::string::npos);
  CHECK(found[0].message.find("set bits") != std::string::npos);
  CHECK(found[0].message.find("exchanged") == std::string::npos);
}
