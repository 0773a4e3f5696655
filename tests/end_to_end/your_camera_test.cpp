// SPDX-License-Identifier: BSD-3-Clause
// The commands of docs/your-camera.md, on a raw recording.
#include <sys/stat.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <thread>

#include "author/markdown_script.hpp"
#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"
#include "support/ros1_tool.hpp"

using namespace tolman::test;

namespace {

/// A run of an uncalibrated camera, as the page says.
Finished runOf(const std::string& source, const std::filesystem::path& folder,
               const std::string& out) {
  std::ofstream(folder / (out + ".yaml"))
      << "source: " << source
      << "\nodometry: {plugin: scanline}\nplace: {plugin: view_templates}\n"
         "cells: {plugin: bayesian_attractor}\nmap: {plugin: experience_map}\n";
  return tolman::test::tolman(
      {"run", (folder / (out + ".yaml")).string(), "--quiet", "--out", (folder / out).string()});
}

std::filesystem::path imageOf(const std::filesystem::path& clip, int index) {
  std::array<char, 16> name{};
  std::snprintf(name.data(), name.size(), "%06d.jpg", index);
  return clip / "image_0" / name.data();
}

}  // namespace

TEST_CASE("a video, a pipe as a camera would be, and a camera that is not there", "[data]") {
  const auto clip = dataOrSkip("kitti_clips/03_left");
  if (!clip) return;
  const TemporaryFolder folder;
  const auto file = folder.path() / "drive.ts";
  cv::VideoWriter writer(file.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'P', 'G', '2'),
                         25, {1240, 374});
  REQUIRE(writer.isOpened());
  for (int i = 0; i < 20; ++i) {
    const cv::Mat image = cv::imread(imageOf(*clip, i).string());
    writer.write(image(cv::Rect(0, 0, 1240, 374)));
  }
  writer.release();
  const Finished video =
      runOf("{plugin: video, path: " + file.string() + "}", folder.path(), "video");
  INFO(video.err);
  REQUIRE(video.exit_code == 0);
  CHECK(readJson(folder.path() / "video/run.json")["counters"]["frames"] == 20);

  const auto pipe = folder.path() / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::thread camera([&] {
    std::ofstream(pipe, std::ios::binary) << std::ifstream(file, std::ios::binary).rdbuf();
  });
  const Finished live =
      runOf("{plugin: video, path: " + pipe.string() + "}", folder.path(), "live");
  camera.join();
  INFO(live.err);
  REQUIRE(live.exit_code == 0);
  CHECK(readText(folder.path() / "live/trajectory.tum") ==
        readText(folder.path() / "video/trajectory.tum"));

  const Finished none = runOf("{plugin: video, path: /dev/video_of_nobody}", folder.path(), "none");
  CHECK(none.exit_code == 5);
  CHECK(contains(none.err, "/dev/video_of_nobody: cannot be opened"));
  CHECK(contains(none.err, "connect the camera"));
}

TEST_CASE("a ROS 1 bag", "[data]") {
  const auto clip = dataOrSkip("kitti_clips/03_left");
  if (!clip || !ros1OrSkip()) return;
  const TemporaryFolder folder;
  Ros1List list(folder.path());
  for (int i = 0; i < 20; ++i) {
    list.compressed("/front/image/compressed", 1'000'000'000 + i * 100'000'000LL, "jpeg",
                    imageOf(*clip, i));
  }
  const auto bag = folder.path() / "drive.bag";
  REQUIRE(list.call("bag", bag, "bz2"));
  const Finished check =
      tolman::test::tolman({"dataset", "check", bag.string(), "--source", "ros_bag"});
  CHECK(contains(check.out, "/front/image/compressed"));
  const Finished run = runOf("{plugin: ros_bag, path: " + bag.string() + "}", folder.path(), "bag");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(readJson(folder.path() / "bag/run.json")["counters"]["frames"] == 20);
}

TEST_CASE("the page leads from a raw pair of EuRoC to a map and to a KITTI folder", "[data]") {
  const auto recording = dataOrSkip("euroc_v101");
  if (!recording) return;
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "page.sh")
      << "set -e\ncd " << folder.path() << "\nexport REC=" << *recording << "\n"
      << scriptOf(readText(inSource("docs/your-camera.md")));
  const std::string path = tolmanProgram().parent_path().string();
  const Finished page = run({"/usr/bin/env", "PATH=" + path + ":/usr/bin:/bin", "bash",
                             (folder.path() / "page.sh").string()});
  INFO(page.out << page.err);
  REQUIRE(page.exit_code == 0);
  CHECK(contains(page.out, "2 radial_tangential cameras of 752x480 px, rectified to"));
  const auto run_file = readJson(folder.path() / "mine_run/run.json");
  CHECK(run_file["source"]["rectification"].get<std::string>().starts_with(
      "2 radial_tangential cameras of 752x480 px, rectified to"));
  CHECK(run_file["source"]["width"] > 752);  // the corners of the distorted images reach far
  CHECK(run_file["counters"]["frames"] == 10);
  CHECK(run_file["counters"]["lost"] == 0);
  std::ifstream times(folder.path() / "mine_kitti/times.txt");
  std::string first;
  std::getline(times, first);
  CHECK(first == "1403715273.262142976");
}
