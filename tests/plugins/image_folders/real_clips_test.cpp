// SPDX-License-Identifier: BSD-3-Clause
// The real clips: figures known from their documentation.
#include <catch2/catch.hpp>

#include "data_folder.hpp"
#include "images_source.hpp"
#include "kitti_source.hpp"

namespace tolman::image_folders {
namespace {

struct Clip {
  SourceInfo info;
  std::vector<std::string> findings;
};

/// What a source says of a clip after looking at each file.
template <class S>
Clip look(S& source, const std::filesystem::path& path, ParameterValues values = {}) {
  values["path"] = path.string();
  Clip clip;
  const std::string problem = configure(source, std::move(values));
  INFO(problem);
  REQUIRE(problem.empty());
  REQUIRE(source.info(clip.info).isOk());
  clip.findings = inspect(source);
  CHECK(clip.findings.size() == 1);  // the description, no problems
  return clip;
}

}  // namespace

TEST_CASE("KITTI 06, 51 pairs, forward and backward twice", "[data]") {
  const auto path = test::dataOrSkip("kitti_clips/06");
  if (!path) return;
  KittiSource source;
  CHECK(look(source, *path).info.description ==
        "KITTI odometry, 51 stereo pairs of 1226x370 px at 9.6 Hz, baseline 0.5372 m, with truth");
  const Clip laps =
      look(source, *path, {{"order", std::string("pingpong")}, {"passes", std::int64_t{4}}});
  CHECK(laps.info.frames == 201);
  Frame frame;
  std::int64_t stamp = -1;
  for (int k = 0; k < 201; ++k) {
    frame = Frame();
    REQUIRE(source.next(frame).isOk());
    REQUIRE(frame.stamp_ns > stamp);
    REQUIRE(frame.right.width() == 1226);
    stamp = frame.stamp_ns;
    if (k % 100 != 0) continue;
    CHECK(frame.source_index == 0);
    CHECK(frame.T_world_camera_truth.isApprox(Eigen::Isometry3d::Identity(), 1e-9));
  }
  CHECK(source.next(frame).code() == StatusCode::EndOfStream);
}

TEST_CASE("KITTI raw 0001, no truth", "[data]") {
  const auto path = test::dataOrSkip("kitti_clips/raw_0001");
  if (!path) return;
  KittiSource source;
  const Clip clip = look(source, *path);
  CHECK(clip.info.frames == 108);
  CHECK(clip.info.rig.width == 1242);
  CHECK(clip.info.rig.baseline == Approx(387.5744 / 721.5377));
  CHECK_FALSE(clip.info.has_truth);
}

TEST_CASE("single cameras of KITTI, PNG and JPEG", "[data]") {
  const auto png = test::dataOrSkip("kitti_clips/00_left");
  const auto jpeg = test::dataOrSkip("kitti_clips/03_left");
  if (!png || !jpeg) return;
  KittiSource source;
  CHECK(look(source, *png).info.frames == 120);
  const Clip clip = look(source, *jpeg);
  CHECK(clip.info.frames == 300);
  CHECK_FALSE(clip.info.rig.isStereo());
  CHECK(clip.info.has_truth);
  std::string failure;
  const std::vector<Frame> frames = readAll(source, failure);
  CHECK(failure.empty());
  REQUIRE(frames.size() == 300);
  CHECK(frames[299].left.format() == PixelFormat::Gray8);
}

TEST_CASE("uncalibrated folders: laps between desks, two laps of a corridor", "[data]") {
  const auto office = test::dataOrSkip("laps_office");
  const auto corridor = test::dataOrSkip("places_two_laps");
  if (!office || !corridor) return;
  ImagesSource source;
  const Clip laps =
      look(source, *office,
           {{"stamps", std::string("frames.csv")}, {"stamps_column", std::string("time_s")}});
  CHECK(laps.info.frames == 2391);
  CHECK(laps.info.rig.width == 160);
  Frame frame;
  REQUIRE(source.next(frame).isOk());
  REQUIRE(source.next(frame).isOk());
  CHECK(frame.stamp_ns == 63'000'000);
  CHECK(look(source, *corridor, {{"rate", 1.0}}).info.description ==
        "images, 84 images of one camera of 512x384 px at 1.0 Hz, uncalibrated, no truth");
}

}  // namespace tolman::image_folders
