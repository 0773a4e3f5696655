// SPDX-License-Identifier: BSD-3-Clause
// tolman dataset render of recordings of every kind: folders that `kitti` or `images` reads.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <thread>

#include "end_to_end/tiny_kitti.hpp"
#include "support/data.hpp"
#include "support/ros_bag_writer.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

struct Imported {
  TemporaryFolder folder;
  fs::path out = folder.path() / "imported";
  Finished finished;

  explicit Imported(const fs::path& recording, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"dataset", "render", recording.string(), "--frames",
                                      "3",       "--out",  out.string()};
    words.insert(words.end(), more.begin(), more.end());
    finished = tolman::test::tolman(words);
  }

  cv::Mat image(const std::string& name) const {
    return cv::imread((out / name).string(), cv::IMREAD_UNCHANGED);
  }
  /// fx, cx, cy of the left camera.
  std::array<double, 3> pinhole() const {
    std::ifstream file(out / "calib.txt");
    std::string name;
    std::array<double, 12> P{};
    file >> name;
    for (double& value : P) file >> value;
    return {P[0], P[2], P[6]};
  }
  /// The data set is sound for the source that it is for.
  void check(const std::string& source = "kitti", const std::vector<std::string>& more = {}) const {
    INFO(finished.out << finished.err);
    REQUIRE(finished.exit_code == 0);
    std::vector<std::string> words = {"dataset", "check", out.string(), "--source", source};
    words.insert(words.end(), more.begin(), more.end());
    const Finished checked = tolman::test::tolman(words);
    INFO(checked.out << checked.err);
    CHECK(checked.exit_code == 0);
    CHECK(contains(checked.out, "3 frames decode"));
  }
};

void writeVideo(const fs::path& clip, const std::string& video) {
  cv::VideoWriter writer;
  for (int i = 0; i < 5; ++i) {
    const cv::Mat image = cv::imread((clip / fmt::format("image_0/{:06}.jpg", i)).string());
    REQUIRE_FALSE(image.empty());
    if (i == 0) writer.open(video, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10, image.size());
    writer.write(image);
  }
}

/// A rectified pair of 96x64 px, three times.
void writeBag(const fs::path& file) {
  const auto info = [](const std::string& topic, double baseline) {
    return RosMessage{topic, "sensor_msgs/msg/CameraInfo", 1'000'000'000,
                      cameraInfoMessage(plainCamera(96, 64, 70, baseline))};
  };
  std::vector<RosMessage> messages = {info("/left/camera_info", 0),
                                      info("/right/camera_info", 0.12)};
  for (int i = 0; i < 3; ++i) {
    const std::int64_t stamp = 1'000'000'000 + i * 50'000'000LL;
    for (const char* topic : {"/left/image_rect", "/right/image_rect"}) {
      std::string pixels;
      for (int p = 0; p < 96 * 64; ++p) pixels += static_cast<char>((p * 7 + i) % 251);
      messages.push_back(
          {topic, "sensor_msgs/msg/Image", stamp, imageMessage({stamp, 96, 64, "mono8", pixels})});
    }
  }
  writeBytes(file, mcapBytes(messages));
}

}  // namespace

TEST_CASE("raw pairs, single cameras and drives are imported rectified", "[data]") {
  for (const char* recording :
       {"euroc_v101", "tumvi_room1", "tum_fr1_xyz", "kitti_raw_unrectified", "kitti_clips/06"}) {
    const auto data = dataOrSkip(recording);
    if (!data) continue;
    INFO(recording);
    const Imported imported(*data);
    imported.check();
  }
}

TEST_CASE("a ROS 2 bag is imported as it is, and scaled with its calibration") {
  const TemporaryFolder folder;
  const fs::path bag = folder.path() / "pair.mcap";
  writeBag(bag);
  const Imported whole(bag);
  whole.check();
  CHECK(whole.image("image_1/000002.png").size() == cv::Size(96, 64));
  const Imported part(bag, {"--set", "images.crop=[8, 4, 80, 60]", "--set", "images.scale=0.75"});
  part.check();
  const cv::Mat image = part.image("image_0/000001.png");
  CHECK(image.size() == cv::Size(60, 45));
  const auto [fx, cx, cy] = whole.pinhole();
  const auto [part_fx, part_cx, part_cy] = part.pinhole();
  CHECK(part_fx == Approx(0.75 * fx));
  CHECK(part_cx == Approx(0.75 * (cx - 8 + 0.5) - 0.5));
  CHECK(part_cy == Approx(0.75 * (cy - 4 + 0.5) - 0.5));
  const Imported outside(bag, {"--set", "images.crop=[8, 4, 96, 60]"});
  CHECK(outside.finished.exit_code == 5);
  CHECK(contains(outside.finished.err, "images.crop is not inside of the images"));
}

TEST_CASE("a video without calibration becomes a folder that images reads", "[data]") {
  const auto clip = dataOrSkip("kitti_clips/03_left");
  if (!clip) return;
  const TemporaryFolder folder;
  const std::string video = (folder.path() / "street.avi").string();
  writeVideo(*clip, video);
  const Imported imported(video);
  CHECK(contains(imported.finished.out, "plugin: images"));
  CHECK_FALSE(fs::exists(imported.out / "calib.txt"));
  imported.check("images", {"--set", "left=image_0", "--set", "stamps=times.txt"});
  const Imported calibrated(video, {"--set", "source.pinhole=[700]"});
  calibrated.check();
}
