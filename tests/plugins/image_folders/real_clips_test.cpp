// SPDX-License-Identifier: BSD-3-Clause
// The real clips: figures known from their documentation.
#include <catch2/catch.hpp>

#include "data_folder.hpp"

namespace tolman::image_folders {
namespace {

template <class P>
Opened<P> look(const std::filesystem::path& path, ParameterValues values = {}) {
  values["path"] = path.string();
  return Opened<P>(DataFolder(), std::move(values));
}

}  // namespace

TEST_CASE("KITTI 06, 51 pairs, forward and backward twice", "[data]") {
  const auto path = test::dataOrSkip("kitti_clips/06");
  if (!path) return;
  const auto laps = look<KittiParameters>(*path, {{"order", std::string("pingpong")},
                                                  {"passes", std::int64_t{2}},
                                                  {"step", std::int64_t{10}}});
  CHECK(laps.info.description ==
        "KITTI odometry, 11 from 51 stereo pairs of 1226x370 px at 9.6 Hz, baseline 0.5372 m, with "
        "truth");
  CHECK(laps.findings.empty());
  REQUIRE(laps.frames.size() == 11);
  CHECK(laps.frames[5].source_index == 50);
  CHECK(laps.frames[10].T_world_camera_truth.isApprox(Eigen::Isometry3d::Identity(), 1e-9));
}

TEST_CASE("KITTI raw 0001, and single cameras of KITTI, PNG and JPEG", "[data]") {
  if (const auto path = test::dataOrSkip("kitti_clips/raw_0001")) {
    const auto clip = look<KittiParameters>(*path, {{"step", std::int64_t{50}}});
    CHECK(clip.info.description.find("3 from 108 stereo pairs of 1242x375") != std::string::npos);
    CHECK(clip.info.rig.baseline == Approx(387.5744 / 721.5377));
    CHECK_FALSE(clip.info.has_truth);
  }
  if (const auto path = test::dataOrSkip("kitti_clips/03_left")) {
    const auto clip = look<KittiParameters>(*path, {{"step", std::int64_t{100}}});
    CHECK(clip.info.frames == 3);
    CHECK_FALSE(clip.info.rig.isStereo());
    CHECK(clip.info.has_truth);
    CHECK(clip.frames[2].left.format() == PixelFormat::Gray8);
  }
}

TEST_CASE("uncalibrated folders: laps between desks, two laps of a corridor", "[data]") {
  if (const auto office = test::dataOrSkip("laps_office")) {
    const auto laps = look<ImagesParameters>(*office, {{"stamps", std::string("frames.csv")},
                                                       {"stamps_column", std::string("time_s")},
                                                       {"last", std::int64_t{1}}});
    CHECK(laps.info.description.find("2 from 2391 images of one camera of 160x") !=
          std::string::npos);
    CHECK(laps.frames[1].stamp_ns == 63'000'000);
  }
  if (const auto corridor = test::dataOrSkip("places_two_laps")) {
    CHECK(look<ImagesParameters>(*corridor, {{"rate", 1.0}}).info.description ==
          "images, 84 images of one camera of 512x384 px at 1.0 Hz, uncalibrated");
  }
}

}  // namespace tolman::image_folders
