// SPDX-License-Identifier: BSD-3-Clause
// tolman init: what it writes for recordings, and that it runs.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"
#include "support/ros1_tool.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

struct Written {
  TemporaryFolder folder;
  fs::path file = folder.path() / "mine.yaml";
  Finished finished;
  std::string text;

  explicit Written(const fs::path& recording, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"init", recording.string(), "--out", file.string()};
    words.insert(words.end(), more.begin(), more.end());
    finished = tolman::test::tolman(words);
    text = readText(file);
  }

  /// It is sound, and tracks its first frames.
  void run(int frames) const {
    INFO(text << finished.err);
    REQUIRE(finished.exit_code == 0);
    REQUIRE(tolman::test::tolman({"check", file.string()}).exit_code == 0);
    const fs::path out = folder.path() / "run";
    std::vector<std::string> words = {"run", file.string(), "--out", out.string(), "-q"};
    const std::string last = "source.last=" + std::to_string(frames - 1);
    words.insert(words.end(), {"--set", last});
    const Finished ran = tolman::test::tolman(words);
    INFO(ran.err);
    REQUIRE(ran.exit_code == 0);
    const auto counters = readJson(out / "run.json")["counters"];
    CHECK(counters["frames"] == frames);
    CHECK(counters["lost"] == 0);
  }
};

struct Expected {
  const char* recording;
  int frames;
  std::vector<std::string> parts;
};

std::vector<Expected> expectedOfData() {
  return {
      {"kitti_clips/06", 20, {"plugin: kitti\n", "direct_sparse_stereo", "'car' is guessed"}},
      {"kitti_clips/01", 20, {"plugin: kitti\n", "direct_sparse_stereo"}},
      {"kitti_clips/raw_0001", 20, {"plugin: kitti\n", "the true path"}},
      {"kitti_clips/00_left", 20, {"direct_sparse_mono", "arbitrary units"}},
      {"kitti_clips/03_left", 20, {"direct_sparse_mono", "'car' is guessed"}},
      {"kitti_motion/00", 20, {"plugin: motion_log\n", "motion_replay"}},
      {"laps_office", 20, {"plugin: images\n", "stamps: frames.csv", "time_s", "scanline"}},
      {"places_two_laps", 20, {"plugin: images\n", "rate: 10\n", "frame rate: 10 Hz are assumed"}},
      {"places_gardens/day_left", 20, {"plugin: images\n", "frame rate: 10 Hz are assumed"}},
      {"places_gardens/night_right", 20, {"plugin: images\n", "scanline"}},
      {"euroc_v101", 10, {"plugin: euroc\n", "direct_sparse_stereo", "'hand' is guessed"}},
      {"tumvi_room1", 4, {"plugin: euroc\n", "equidistant", "'hand' is guessed"}},
      {"tum_fr1_xyz", 10, {"plugin: tum\n", "feature_rgbd", "'hand' is guessed"}},
      {"kitti_raw_unrectified", 6, {"plugin: kitti_raw\n", "rate: 10\n", "10 Hz are assumed"}},
  };
}

}  // namespace

TEST_CASE("init writes a configuration for each data set, which runs", "[data]") {
  for (const Expected& expected : expectedOfData()) {
    const auto recording = dataOrSkip(expected.recording);
    if (!recording) continue;
    INFO(expected.recording);
    const Written written(*recording);
    for (const std::string& part : expected.parts) {
      INFO(part);
      CHECK(contains(written.text, part));
    }
    written.run(expected.frames);
  }
}

TEST_CASE("init finds a pair of folders, a calibration and times in names", "[data]") {
  const auto euroc = dataOrSkip("euroc_v101");
  const auto tumvi = dataOrSkip("tumvi_room1");
  if (!euroc || !tumvi) return;
  const TemporaryFolder folder;
  const fs::path rig = folder.path() / "rig";
  fs::create_directories(rig);
  fs::create_directory_symlink(*tumvi / "cam0/images", rig / "camera_left");
  fs::create_directory_symlink(*tumvi / "cam1/images", rig / "camera_right");
  fs::copy(*tumvi / "camchain.yaml", rig / "camchain.yaml");
  const Written written(rig);
  CHECK(contains(written.text, "plugin: images\n"));
  CHECK(contains(written.text, "left: camera_left\n  right: camera_right\n"));
  CHECK(contains(written.text, "calibration: camchain.yaml\n"));
  CHECK(contains(written.text, "stamps_in_names: true\n  stamps_unit: ns\n"));
  CHECK_FALSE(contains(written.text, "frame rate"));
  written.run(4);
}

TEST_CASE("init finds the unit of times, and names times that cannot be used") {
  const TemporaryFolder folder;
  const auto writeImages = [&](const fs::path& images, const std::string& format) {
    fs::create_directories(images);
    cv::Mat image(60, 80, CV_8UC1);
    for (int i = 0; i < 6; ++i) {
      cv::randu(image, 0, 255);
      cv::imwrite((images / fmt::format(fmt::runtime(format), i)).string(), image);
    }
  };
  const auto textWith = [&](const std::string& name, const std::string& times) {
    const fs::path images = folder.path() / name;
    writeImages(images, "{:06}.png");
    std::ofstream(images / "times.csv") << times;
    return Written(images).text;
  };
  const std::string regular = textWith("a", "frame,time\n0,0\n1,33\n2,66\n3,99\n4,132\n5,165\n");
  CHECK(contains(regular, "stamps_unit: ms\n"));
  CHECK_FALSE(contains(regular, "beside the images"));
  const std::string epoch = textWith("b",
                                     "frame,stamp\n0,1700000000\n1,1700000001\n2,1700000002\n"
                                     "3,1700000003\n4,1700000004\n5,1700000005\n");
  CHECK(contains(epoch, "stamps_unit: s\n"));
  const std::string unsorted = textWith("c", "frame,time\n0,0\n1,1\n2,9\n3,3\n4,4\n5,5\n");
  CHECK_FALSE(contains(unsorted, "stamps_unit"));
  CHECK(contains(unsorted, "#   - a file beside the images: "));
  CHECK(contains(unsorted, "times.csv"));
  writeImages(folder.path() / "d", "170000000{}.25.png");
  CHECK(contains(Written(folder.path() / "d").text, "stamps_in_names: true\n  stamps_unit: s\n"));
  // Decimals of different lengths have no order but that of the times.
  writeImages(folder.path() / "e", "170000000{}.25.png");
  fs::rename(folder.path() / "e/1700000003.25.png", folder.path() / "e/1700000003.5.png");
  const Written uneven(folder.path() / "e");
  CHECK(uneven.finished.exit_code == 0);
  CHECK(contains(uneven.text, "stamps_in_names: true\n  stamps_unit: s\n"));
  const Written below(folder.path(), {"--set", "left=e"});
  CHECK(contains(below.text, "  left: e\n  stamps_in_names: true\n"));
}

TEST_CASE("only the source of the layout says what is wrong, and a recording can be run") {
  const TemporaryFolder folder;
  const fs::path drive = folder.path() / "drive";
  writeTinyKitti(drive, 6);
  const Finished ran =
      tolman::test::tolman({"run", drive.string(), "--out", (folder.path() / "run").string()});
  CHECK((ran.exit_code == 0 || ran.exit_code == 6));  // grey squares are hard to track
  CHECK(contains(ran.err, "# KITTI odometry, 6 stereo pairs"));
  CHECK(contains(ran.err, "#   - what carries the camera: 'car' is guessed"));
  CHECK(readJson(folder.path() / "run/run.json")["counters"]["frames"] == 6);
  std::ofstream(drive / "calib.txt")
      << "P0: 70 0 40 0 0 70 30 0 0 0 1 0\nP1: 70 0 40 -3x 0 70 30 0 0 0 1 0\n";
  for (const char* command : {"init", "run"}) {
    const Finished refused = tolman::test::tolman({command, drive.string()});
    CHECK(refused.exit_code == 5);
    CHECK(contains(refused.err, "\n  kitti: "));
    CHECK(contains(refused.err, "calib.txt:2: '-3x' is no finite number"));
    CHECK_FALSE(contains(refused.err, "\n  tum: "));
  }
  const Finished of_run = tolman::test::tolman({"init", (folder.path() / "run").string()});
  CHECK(of_run.exit_code == 5);
  CHECK(contains(of_run.err, "is a run directory, not a recording"));
}

TEST_CASE("init writes a configuration for a video, which runs", "[data]") {
  const auto clip = dataOrSkip("kitti_clips/03_left");
  if (!clip) return;
  const TemporaryFolder folder;
  const std::string video = (folder.path() / "street.avi").string();
  cv::VideoWriter writer;
  for (int i = 0; i < 20; ++i) {
    const cv::Mat image = cv::imread((*clip / fmt::format("image_0/{:06}.jpg", i)).string());
    REQUIRE_FALSE(image.empty());
    if (i == 0) writer.open(video, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10, image.size());
    writer.write(image);
  }
  writer.release();
  const Written written(video);
  CHECK(contains(written.text, "name: street\n"));
  CHECK(contains(written.text, "plugin: video\n"));
  CHECK(contains(written.text, "plugin: scanline\n"));
  CHECK_FALSE(contains(written.text, "frame rate"));  // a video has its own
  written.run(20);
}

TEST_CASE("init writes a configuration for a ROS 1 bag, which runs", "[data]") {
  const auto clip = dataOrSkip("kitti_clips/03_left");
  if (!clip || !ros1OrSkip()) return;
  const TemporaryFolder folder;
  Ros1List uncalibrated(folder.path());
  Ros1List calibrated(folder.path());
  const std::vector<double> K = {721.5377, 0, 609.5593, 0, 721.5377, 172.854, 0, 0, 1};
  calibrated.camera("/front/camera_info", 1242, 375, "plumb_bob", {}, K,
                    {1, 0, 0, 0, 1, 0, 0, 0, 1}, {K[0], 0, K[2], 0, 0, K[4], K[5], 0, 0, 0, 1, 0});
  for (int i = 0; i < 20; ++i) {
    const fs::path image = *clip / fmt::format("image_0/{:06}.jpg", i);
    for (Ros1List* list : {&uncalibrated, &calibrated}) {
      list->compressed("/front/image_rect/compressed", 1'000'000'000 + i * 100'000'000LL, "jpeg",
                       image);
    }
  }
  const auto write = [&](const Ros1List& list, const std::string& compression) {
    const fs::path bag = folder.path() / (compression + ".bag");
    REQUIRE(list.call("bag", bag, compression));
    const Written written(bag);
    CHECK(contains(written.text, "name: " + compression + "\n"));
    CHECK(contains(written.text, "plugin: ros_bag\n"));
    CHECK_FALSE(contains(written.text, "frame rate"));  // a bag has its own
    written.run(20);
    return written.text;
  };
  CHECK(contains(write(uncalibrated, "bz2"), "plugin: scanline\n"));
  CHECK(contains(write(calibrated, "lz4"), "plugin: direct_sparse_mono\n"));
}

TEST_CASE("init says why a recording cannot be read, and takes parameters", "[data]") {
  const auto bag = dataOrSkip("ros2_bags/test_bag_mcap");
  if (!bag) return;
  const Written refused(*bag);
  CHECK(refused.finished.exit_code == 5);
  CHECK(contains(refused.finished.err, "no source reads it\n"));
  CHECK(contains(refused.finished.err, "\n  ros_bag: "));
  CHECK(contains(refused.finished.err, "several cameras; set left to one of: "));
  CHECK_FALSE(fs::exists(refused.file));
  const Written written(*bag, {"--set", "left=/test/sensor_msgs/image"});
  CHECK(written.finished.exit_code == 5);  // its images are too short, which is another reason
  CHECK(contains(written.finished.err, "has 30 bytes of pixels instead of 921600"));
}

TEST_CASE("init names the folders of images that it leaves out, and takes a pair first") {
  const TemporaryFolder folder;
  const fs::path rig = folder.path() / "rig";
  writeTinyKitti(folder.path() / "sequence", 3);
  const auto add = [&](const std::string& name, const char* images) {
    fs::create_directories(rig / name);
    fs::copy(folder.path() / "sequence" / images, rig / name, fs::copy_options::recursive);
  };
  add("aerial", "image_0");
  add("forward/data", "image_1");
  const Written single(rig);
  REQUIRE(single.finished.exit_code == 0);
  CHECK(contains(single.text, "  left: aerial\n"));
  CHECK(contains(single.text, "which camera: there are images also in forward/data (source.left"));
  add("left", "image_0");
  add("right", "image_1");
  std::ofstream(rig / "pair.yaml")
      << "cam0:\n  camera_model: pinhole\n  intrinsics: [100, 100, 80, 30]\n"
         "  distortion_model: none\n  resolution: [160, 60]\n"
         "cam1:\n  camera_model: pinhole\n  intrinsics: [100, 100, 80, 30]\n"
         "  distortion_model: none\n  resolution: [160, 60]\n"
         "  T_cn_cnm1: [1, 0, 0, -0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]\n";
  const Written pair(rig);
  REQUIRE(pair.finished.exit_code == 0);
  CHECK(contains(pair.text, "  left: left\n  right: right\n"));
  CHECK(contains(pair.text, "  calibration: pair.yaml\n"));
  CHECK(contains(pair.text, "there are images also in aerial, forward/data (source.left"));
  CHECK_FALSE(contains(Written(folder.path() / "sequence").text, "which camera"));
}

TEST_CASE("init takes what carries the camera, keeps a file, and prints without one") {
  const TemporaryFolder folder;
  writeTinyKitti(folder.path() / "sequence", 3);
  const std::string recording = (folder.path() / "sequence").string();
  const Written toy(recording, {"--motion", "toy"});
  REQUIRE(toy.finished.exit_code == 0);
  CHECK(contains(toy.text, "experience_spacing: 0.25\n"));
  CHECK_FALSE(contains(toy.text, "is guessed"));
  const Finished again = tolman::test::tolman({"init", recording, "--out", toy.file.string()});
  CHECK(again.exit_code == 8);
  CHECK(contains(again.err, "exists; choose another --out"));
  CHECK(readText(toy.file) == toy.text);
  CHECK(
      tolman::test::tolman({"init", recording, "--out", toy.file.string(), "--force"}).exit_code ==
      0);
  const fs::path link = folder.path() / "link.yaml";
  fs::create_symlink(folder.path() / "absent.yaml", link);
  CHECK(tolman::test::tolman({"init", recording, "--out", link.string()}).exit_code == 8);
  CHECK(fs::is_symlink(link));
  const Finished printed = tolman::test::tolman({"init", recording});
  CHECK(printed.out == readText(toy.file));
  CHECK(tolman::test::tolman({"init", recording, "--motion", "ship"}).exit_code == 2);
  CHECK(tolman::test::tolman({"init", recording, "--set", "left"}).exit_code == 2);
  const Finished nothing = tolman::test::tolman({"init", (folder.path() / "no").string()});
  CHECK(nothing.exit_code == 5);
  CHECK(contains(nothing.err, "No such file"));
}
