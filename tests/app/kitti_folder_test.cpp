// SPDX-License-Identifier: BSD-3-Clause
// The text files of a rendered folder, and the handling of a folder that is not empty.
#include "app/kitti_folder.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "support/data.hpp"

using namespace tolman;
namespace fs = std::filesystem;

namespace {

CameraRig kittiRig() {
  CameraRig rig;
  rig.width = 1241;
  rig.height = 376;
  rig.calibrated = true;
  rig.pinhole = {718.856, 718.856, 607.1928, 185.2157};
  rig.baseline = 0.5;
  return rig;
}

void touch(const fs::path& file) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "x";
}

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("calibration has four matrices, the right ones with -fx * baseline") {
  CHECK(app::calibrationText(kittiRig()) ==
        "P0: 718.856 0 607.1928 0 0 718.856 185.2157 0 0 0 1 0\n"
        "P1: 718.856 0 607.1928 -359.428 0 718.856 185.2157 0 0 0 1 0\n"
        "P2: 718.856 0 607.1928 0 0 718.856 185.2157 0 0 0 1 0\n"
        "P3: 718.856 0 607.1928 -359.428 0 718.856 185.2157 0 0 0 1 0\n");
}

TEST_CASE("times are exact to the nanosecond") {
  CHECK(app::timesText({0, 103'662'200, 1'000'000'001, 1'700'000'000'123'456'789}) ==
        "0.000000000\n0.103662200\n1.000000001\n1700000000.123456789\n");
  CHECK(app::timesText({-1'500'000'000, -1}) == "-1.500000000\n-0.000000001\n");
}

TEST_CASE("a new folder is made with its parents, an empty one is taken") {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "a/b/c";
  CHECK(app::KittiFolder::create(path, false).isOk());
  CHECK(app::KittiFolder::create(path, false).isOk());
  CHECK(fs::is_directory(path));
}

TEST_CASE("a folder that holds something is left alone") {
  const test::TemporaryFolder folder;
  touch(folder.path() / "thesis.tex");
  const auto refused = app::KittiFolder::create(folder.path(), false);
  REQUIRE_FALSE(refused.isOk());
  CHECK(refused.status().message() ==
        folder.path().string() +
            ": is not empty; choose another --out, or give --force to replace an earlier "
            "rendering");
  const auto file = app::KittiFolder::create(folder.path() / "thesis.tex", true);
  REQUIRE_FALSE(file.isOk());
  CHECK(file.status().message() == (folder.path() / "thesis.tex").string() +
                                       ": is not a folder and cannot be made; choose another "
                                       "--out");
}

TEST_CASE("replacing removes an earlier rendering, and nothing else") {
  const test::TemporaryFolder folder;
  for (const char* ours :
       {"image_0/000000.png", "image_0/.000001.png.partial", "image_1/000000.png",
        "image_3/1234567.png", "depth_0/000000.png", "calib.txt", "times.txt", "poses.txt",
        "loops.txt", ".tolman-rendering"}) {
    touch(folder.path() / ours);
  }
  for (const char* foreign : {"thesis.tex", "velodyne/000000.png"}) touch(folder.path() / foreign);
  REQUIRE(app::KittiFolder::create(folder.path(), true).isOk());
  CHECK(entries(folder.path()) == 3);  // with the mark of the new one
  CHECK(fs::exists(folder.path() / "thesis.tex"));
  CHECK(fs::exists(folder.path() / "velodyne/000000.png"));
}

TEST_CASE("a data set that no rendering has made is not replaced") {
  const test::TemporaryFolder folder;
  touch(folder.path() / "image_0/000000.png");
  touch(folder.path() / "calib.txt");
  const auto refused = app::KittiFolder::create(folder.path(), true);
  REQUIRE_FALSE(refused.isOk());
  CHECK(refused.status().message().starts_with(folder.path().string() +
                                               ": holds no rendering of Tolman"));
  CHECK(fs::exists(folder.path() / "image_0/000000.png"));
  CHECK(fs::exists(folder.path() / "calib.txt"));
}

TEST_CASE("an image that cannot be written is named, and leaves nothing behind") {
  const test::TemporaryFolder folder;
  const auto target = app::KittiFolder::create(folder.path() / "out", false);
  REQUIRE(target.isOk());
  touch(folder.path() / "out/image_0");  // a file where the folder has to be
  Frame frame;
  frame.left = Image::create(4, 3, PixelFormat::Gray8, [](std::uint8_t*) {});
  const Status status = target.value().writeFrame(7, frame, "");
  REQUIRE_FALSE(status.isOk());
  CHECK(status.message() == (folder.path() / "out/image_0/000007.png").string() +
                                ": cannot be created; check folder and permissions "
                                "(Not a directory)");
  CHECK(entries(folder.path() / "out") == 2);  // with the mark
}

TEST_CASE("poses and loops are written with the whole truth only") {
  const test::TemporaryFolder folder;
  const auto target = app::KittiFolder::create(folder.path(), false);
  const std::vector<std::int64_t> stamps = {0, 100'000'000};
  evaluation::Trajectory truth = {{0, 0, Eigen::Isometry3d::Identity()}};
  REQUIRE(target.value().writeTexts(kittiRig(), stamps, truth, {}).isOk());
  CHECK(entries(folder.path()) == 3);
  truth.push_back({1, 100'000'000, Eigen::Isometry3d::Identity()});
  REQUIRE(target.value().writeTexts(kittiRig(), stamps, truth, {}).isOk());
  CHECK(entries(folder.path()) == 5);
}
