// SPDX-License-Identifier: BSD-3-Clause
// The source after rectification: cameras and images that the stages get.
#include "engine/rectified_source.hpp"

#include <catch2/catch.hpp>

#include "host/fixture_plugins.hpp"
#include "support/context.hpp"

using namespace tolman;

namespace {

/// Two raw pairs of 64x48 px, with the coefficient k1.
struct RawPair {
  explicit RawPair(const config::RectificationSettings& settings = {}, double k1 = -0.1,
                   const config::ImageSettings& images = {})
      : context({{"k1", k1}}),
        source(test::fixtureInstance("raw_pair", "raw_pair"), settings, images) {
    REQUIRE(source.instance().configure(context).isOk());
  }
  test::TestContext context;
  engine::RectifiedSource source;
  SourceInfo info;
};

config::RectificationSettings off() { return {config::RectificationMode::Off, 1, 90}; }

}  // namespace

TEST_CASE("stages get the rectified cameras, and images of their size") {
  RawPair pair;
  REQUIRE(pair.source.info(pair.info).isOk());
  const CameraRig& rig = pair.info.rig;
  CHECK(rig.calibrated);
  CHECK(rig.baseline == Approx(0.25));
  CHECK(rig.width > 50);
  CHECK(rig.width < 80);
  CHECK_THAT(
      pair.info.description,
      Catch::StartsWith("two raw pairs; 2 radial_tangential cameras of 64x48 px, rectified"));
  Frame frame;
  REQUIRE(pair.source.next(frame).isOk());
  CHECK(frame.left.width() == rig.width);
  CHECK(frame.right.height() == rig.height);
  CHECK(pair.source.rawRig().cameras.size() == 2);
  REQUIRE(pair.source.next(frame).isOk());
  CHECK(pair.source.next(frame).code() == StatusCode::EndOfStream);
}

TEST_CASE("without rectification stages get the left image as it is, uncalibrated") {
  RawPair pair(off());
  REQUIRE(pair.source.info(pair.info).isOk());
  CHECK_FALSE(pair.info.rig.calibrated);
  CHECK(pair.info.rig.width == 64);
  Frame frame;
  REQUIRE(pair.source.next(frame).isOk());
  CHECK(frame.left.width() == 64);
  CHECK(frame.right.empty());
  CHECK_THAT(pair.source.text(), Catch::Contains("not rectified"));
}

TEST_CASE("a calibration that cannot be is refused before the first frame") {
  RawPair pair({}, -500);
  const Status status = pair.source.info(pair.info);
  CHECK(status.code() == StatusCode::InvalidInput);
  CHECK_THAT(status.message(), Catch::StartsWith("the images cannot be rectified: ") &&
                                   Catch::Contains("rectification.mode: off"));
}

TEST_CASE("rectified images are cropped and scaled, and the cameras follow") {
  RawPair whole;
  REQUIRE(whole.source.info(whole.info).isOk());
  RawPair part({}, -0.1, {{2, 1, 48, 40}, 0.8});
  REQUIRE(part.source.info(part.info).isOk());
  CHECK(part.info.rig.width == 38);
  CHECK(part.info.rig.height == 32);
  CHECK(part.info.rig.pinhole.fx == Approx(whole.info.rig.pinhole.fx * 38 / 48));
  CHECK(part.info.rig.baseline == whole.info.rig.baseline);
  CHECK_THAT(part.info.description, Catch::EndsWith(" scaled to 38x32 px"));
  Frame frame;
  REQUIRE(part.source.next(frame).isOk());
  CHECK(frame.left.width() == 38);
  CHECK(frame.right.height() == 32);
}

TEST_CASE("a crop outside of the images is refused before the first frame") {
  RawPair part({}, -0.1, {{40, 0, 64, 40}, 1});
  const Status status = part.source.info(part.info);
  CHECK(status.code() == StatusCode::InvalidParameter);
  CHECK_THAT(status.message(), Catch::StartsWith("images.crop is not inside of the images"));
}
