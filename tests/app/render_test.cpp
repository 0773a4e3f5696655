// SPDX-License-Identifier: BSD-3-Clause
// tolman dataset render: the source kitti reads the rendered frames again, bit for bit.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <thread>

#include "app/painted_source.hpp"
#include "end_to_end/tiny_kitti.hpp"
#include "evaluation/trajectory.hpp"
#include "layouts.hpp"
#include "support/context.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

using namespace tolman;
using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

const std::string kPlugins = inBuild("tests/fixtures/plugins/painted");

/// A configuration of nothing but the painted source, and a folder to render to.
struct Easel {
  TemporaryFolder folder;
  fs::path config = folder.path() / "painted.yaml";
  fs::path out = folder.path() / "rendered";

  Easel() { std::ofstream(config) << "source: {plugin: painted}\n"; }
  std::vector<std::string> command(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"dataset",    "render",        config.string(), "--out",
                                      out.string(), "--plugin-path", kPlugins};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  Finished render(const std::vector<std::string>& more = {}) const {
    return tolman::test::tolman(command(more));
  }
  void refused(const std::vector<std::string>& more, int exit_code, const std::string& err) const {
    const Finished finished = render(more);
    CHECK(finished.exit_code == exit_code);
    CHECK(finished.err == err);
  }
};

/// The frames that the kitti source reads, all of them.
struct ReadBack {
  SourceInfo info;
  std::vector<Frame> frames;

  explicit ReadBack(const fs::path& folder, bool colour = false) {
    image_folders::LayoutSource<image_folders::KittiParameters> source;
    TestContext context({{"path", folder.string()}, {"colour", colour}});
    const Status ready = source.configure(context);
    INFO(ready.message());
    REQUIRE(ready.isOk());
    REQUIRE(source.info(info).isOk());
    for (Frame frame; source.next(frame).isOk(); frame = {}) frames.push_back(frame);
    CHECK(static_cast<std::int64_t>(frames.size()) == info.frames);
  }
};

void checkPixels(const Image& image, std::int64_t frame, int camera) {
  REQUIRE(image.width() == fixture::kPaintedWidth);
  REQUIRE(image.height() == fixture::kPaintedHeight);
  bool equal = true;
  for (int r = 0; r < image.height(); ++r) {
    for (int c = 0; c < image.width() * bytesPerPixel(image.format()); ++c) {
      equal = equal && image.row(r)[c] == fixture::paintedPixel(frame, camera, r, c);
    }
  }
  INFO("frame " << frame << ", camera " << camera);
  CHECK(equal);
}

std::ptrdiff_t files(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

std::ptrdiff_t lines(const fs::path& file) {
  const std::string text = readText(file);
  return std::count(text.begin(), text.end(), '\n');
}

}  // namespace

TEST_CASE("images, calibration, times and poses come back through the kitti source") {
  const Easel easel;
  const Finished finished = easel.render();
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  CHECK(contains(finished.out, "20 written, 0 left out"));
  const ReadBack back(easel.out);
  REQUIRE(back.frames.size() == 20);
  CHECK(back.info.rig.pinhole.fx == 30);
  CHECK(back.info.rig.pinhole.fy == 30);
  CHECK(back.info.rig.pinhole.cx == 19.5);
  CHECK(back.info.rig.pinhole.cy == 11.5);
  CHECK(back.info.rig.baseline == Approx(0.25).epsilon(1e-12));
  CHECK(back.info.has_truth);
  const Eigen::Isometry3d T_start_world = fixture::paintedPose(0).inverse();
  for (const Frame& frame : back.frames) {
    CHECK(frame.stamp_ns == 50'000'001 * frame.frame);
    checkPixels(frame.left, frame.frame, 0);
    checkPixels(frame.right, frame.frame, 1);
    const Eigen::Isometry3d expected = T_start_world * fixture::paintedPose(frame.frame);
    CHECK((frame.T_world_camera_truth.matrix() - expected.matrix()).cwiseAbs().maxCoeff() < 1e-6);
  }
  CHECK_FALSE(fs::exists(easel.out / "depth_0"));
}

TEST_CASE("a rendered KITTI folder is the folder again") {
  const TemporaryFolder folder;
  const fs::path sequence = folder.path() / "sequence";
  const fs::path out = folder.path() / "rendered";
  writeTinyKitti(sequence, 12);
  // All stages are there, and steady is not on the search path: only the source is loaded.
  const auto config = writeTinyConfig(folder.path(), sequence);
  const Finished finished =
      tolman::test::tolman({"dataset", "render", config.string(), "--out", out.string()});
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  const ReadBack before(sequence);
  const ReadBack after(out);
  REQUIRE(after.frames.size() == before.frames.size());
  CHECK(after.info.rig.baseline == before.info.rig.baseline);
  for (std::size_t i = 0; i < after.frames.size(); ++i) {
    const Frame& a = after.frames[i];
    const Frame& b = before.frames[i];
    CHECK(a.stamp_ns == b.stamp_ns);
    for (int r = 0; r < b.left.height(); ++r) {
      const auto width = static_cast<std::size_t>(b.left.width());
      CHECK(std::memcmp(a.left.row(r), b.left.row(r), width) == 0);
      CHECK(std::memcmp(a.right.row(r), b.right.row(r), width) == 0);
    }
    CHECK(a.T_world_camera_truth.isApprox(b.T_world_camera_truth, 1e-9));
  }
  CHECK(tolman::test::tolman({"dataset", "check", out.string()}).exit_code == 0);
}

TEST_CASE("depth maps are 16-bit, metres times 256") {
  const Easel easel;
  const Finished finished = easel.render({"--depth", "--set", "source.frames=3"});
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  CHECK(files(easel.out / "depth_0") == 3);
  const cv::Mat map = cv::imread((easel.out / "depth_0/000002.png").string(), cv::IMREAD_UNCHANGED);
  REQUIRE(map.type() == CV_16UC1);
  REQUIRE(map.cols == fixture::kPaintedWidth);
  for (int r = 0; r < map.rows; ++r) {
    for (int c = 0; c < map.cols; ++c) {
      CHECK(map.at<std::uint16_t>(r, c) / 256.0F == fixture::paintedDepth(2, r, c));
    }
  }
}

TEST_CASE("colour goes where KITTI has its colour cameras") {
  const Easel easel;
  REQUIRE(easel.render({"--set", "source.colour=true"}).exit_code == 0);
  CHECK_FALSE(fs::exists(easel.out / "image_0"));
  const ReadBack back(easel.out, true);
  CHECK(back.info.rig.baseline == Approx(0.25).epsilon(1e-12));
  checkPixels(back.frames[5].left, 5, 0);
  checkPixels(back.frames[5].right, 5, 1);
}

TEST_CASE("loops.txt lists the second round") {
  const Easel easel;
  const Finished finished = easel.render({"--set", "source.frames=140", "--json"});
  REQUIRE(finished.exit_code == 0);
  const auto json = nlohmann::json::parse(finished.out);
  CHECK(json["frames"] == 140);
  // 125.66 m around; the last 5 m before the start are near it already.
  CHECK(json["revisits_same"] == 140 - 121);
  CHECK(json["revisits_opposite"] == 0);
  const std::string loops = readText(easel.out / "loops.txt");
  CHECK(contains(loops, "\n121 0 same 4.6"));
  CHECK(contains(loops, "\n139 13 same 0.3"));
  CHECK(lines(easel.out / "loops.txt") == 20);
}

TEST_CASE("frames without a sound image are left out, and the rest closes up") {
  const Easel easel;
  const Finished finished = easel.render({"--set", "source.defect_every=5"});
  REQUIRE(finished.exit_code == 0);
  CHECK(contains(finished.out, "16 written, 4 left out"));
  CHECK(contains(finished.err, "frame 4 is left out, the folder cannot have a gap: spilt"));
  const ReadBack back(easel.out);
  REQUIRE(back.frames.size() == 16);
  checkPixels(back.frames[4].left, 5, 0);
  CHECK(back.frames[4].stamp_ns == 5 * 50'000'001);
  const Eigen::Isometry3d expected = fixture::paintedPose(0).inverse() * fixture::paintedPose(5);
  CHECK(back.frames[4].T_world_camera_truth.isApprox(expected, 1e-9));
}

TEST_CASE("--frames takes the first ones; the folder is the same for any number of threads") {
  const Easel easel;
  REQUIRE(easel.render({"--frames", "7", "--threads", "1"}).exit_code == 0);
  CHECK(ReadBack(easel.out).frames.size() == 7);
  const std::string image = readText(easel.out / "image_1/000006.png");
  const std::string poses = readText(easel.out / "poses.txt");
  REQUIRE(easel.render({"--frames", "7", "--threads", "4", "--force"}).exit_code == 0);
  CHECK(readText(easel.out / "image_1/000006.png") == image);
  CHECK(readText(easel.out / "poses.txt") == poses);
}

TEST_CASE("refusals name the remedy") {
  const Easel easel;
  std::ofstream(easel.folder.path() / "empty.yaml") << "seed: 1\n";
  SECTION("depth is declared, but does not come") {
    easel.refused({"--depth", "--set", "source.forget_depth=true", "--quiet"}, 5,
                  "frame 0: the source gives no sensor array 'depth.left'; leave out --depth\n");
  }
  SECTION("no source") {
    const Finished finished = tolman::test::tolman(
        {"dataset", "render", (easel.folder.path() / "empty.yaml").string(), "--out", "x"});
    CHECK(finished.exit_code == 3);
    CHECK(contains(finished.err, "source: the stage is missing; add 'source: {plugin: ...}'"));
  }
  SECTION("no folder") {
    CHECK(tolman::test::tolman({"dataset", "render", easel.config.string()}).exit_code == 2);
  }
  SECTION("no frame is sound") {
    easel.refused({"--set", "source.defect_every=1", "--quiet"}, 5,
                  "the source gave no frame with a sound image\n");
  }
}

TEST_CASE("a source that cannot give depth is refused before anything is written") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 2);
  const auto config = writeTinyConfig(folder.path(), folder.path() / "sequence");
  const fs::path out = folder.path() / "rendered";
  const Finished finished = tolman::test::tolman(
      {"dataset", "render", config.string(), "--out", out.string(), "--depth"});
  CHECK(finished.exit_code == 3);
  CHECK(contains(finished.err, "--set source.depth=true: source.depth: unknown parameter"));
  CHECK_FALSE(fs::exists(out));
}

TEST_CASE("a source is never rendered onto its own data, force or not") {
  const TemporaryFolder folder;
  const fs::path sequence = folder.path() / "sequence";
  writeTinyKitti(sequence, 2);
  const auto config = writeTinyConfig(folder.path(), sequence);
  for (const fs::path& out :
       {sequence, folder.path(), folder.path() / "sequence/../sequence/.", sequence / "image_0"}) {
    const Finished finished = tolman::test::tolman(
        {"dataset", "render", config.string(), "--out", out.string(), "--force"});
    CHECK(finished.exit_code == 8);
    CHECK(finished.err == out.string() + ": the source reads from there; choose another --out\n");
  }
  CHECK(files(sequence / "image_0") == 2);
}

TEST_CASE("a failing source leaves a data set of what came before, and its exit code") {
  const Easel easel;
  const Finished finished = easel.render({"--set", "source.fail_at=9", "--quiet"});
  CHECK(finished.exit_code == 5);
  CHECK(finished.err == "source (painted), next, frame 9: the paint ran out; buy more\n");
  CHECK(ReadBack(easel.out).frames.size() == 9);
}

TEST_CASE("SIGINT leaves whole files that are a data set, and exits with 130") {
  const Easel easel;
  auto words = easel.command({"--set", "source.frames=1000000", "--depth"});
  words.insert(words.begin(), tolmanProgram().string());
  Process process(words, easel.folder.path());
  for (int i = 0; i < 3000 && !fs::exists(easel.out / "image_0/000003.png"); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  process.signal(SIGINT);
  const Finished finished = process.wait();
  INFO(finished.err);
  CHECK(finished.exit_code == 130);
  const auto images = files(easel.out / "image_0");
  CHECK(images > 3);
  for (const char* name : {"image_1", "depth_0"}) CHECK(files(easel.out / name) == images);
  CHECK(lines(easel.out / "times.txt") == images);
  CHECK(lines(easel.out / "poses.txt") == images);
  CHECK(tolman::test::tolman({"dataset", "check", easel.out.string()}).exit_code == 0);
}
