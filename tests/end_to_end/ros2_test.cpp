// SPDX-License-Identifier: BSD-3-Clause
// Live ROS 2 on the loopback: another DDS than ours, in processes of its own, publishes images and
// receives what Tolman publishes (support/fast_dds_peer.cpp).
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <opencv2/imgcodecs.hpp>
#include <thread>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"
#include "support/ros_bag_writer.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

constexpr std::int64_t kFirst_ns = 1'700'000'000'000'000'000;

bool ros2LiveOrSkip() {
#ifdef TOLMAN_FAST_DDS_PEER
  return true;
#else
  std::cerr << "SKIPPED: no Fast DDS, or a build without Cyclone DDS "
               "(scripts/install-dependencies --ros)\n";
  skips().push_back("Fast DDS");
  return false;
#endif
}

std::string peerProgram() {
#ifdef TOLMAN_FAST_DDS_PEER
  return TOLMAN_FAST_DDS_PEER;
#else
  return "";
#endif
}

int freeDomain() {
  static int next = static_cast<int>(getpid() % 150);
  return 10 + next++ % 150;
}

/// A domain of its own, and the processes in it.
struct Robot {
  TemporaryFolder temporary;
  fs::path folder = temporary.path();
  int domain = freeDomain();
  std::vector<std::unique_ptr<Process>> processes;

  Robot() = default;
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;
  ~Robot() {
    for (const auto& process : processes) {
      process->signal(SIGKILL);
      (void)process->wait();
    }
  }

  Process& start(const std::vector<std::string>& command) {
    const fs::path own = folder / ("process" + std::to_string(processes.size()));
    fs::create_directories(own);
    processes.push_back(std::make_unique<Process>(command, own));
    return *processes.back();
  }
  /// Publishes `pairs` pairs at 10 Hz.
  Process& publish(const fs::path& list, const std::string& delivery, const std::string& then) {
    return start(
        {peerProgram(), "publish", std::to_string(domain), list.string(), "10", delivery, then});
  }
  void listen(const std::string& name) {
    start({peerProgram(), "listen", std::to_string(domain), "/tolman", (folder / name).string()});
    waitFor(name, "ready", 1);
  }
  std::vector<std::string> lines(const std::string& name, const std::string& word) const {
    std::vector<std::string> found;
    std::ifstream in(folder / name);
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with(word)) found.push_back(line);
    }
    return found;
  }
  void waitFor(const std::string& name, const std::string& word, std::size_t count) const {
    for (int i = 0; i < 300 && lines(name, word).size() < count; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    INFO(name << " " << word);
    REQUIRE(lines(name, word).size() >= count);
  }
  /// `source`: parameters of ros2, or a whole source.
  std::vector<std::string> command(const std::string& source, const std::string& out) const {
    const std::string network = "domain: " + std::to_string(domain) + ", peers: localhost";
    const fs::path file = folder / (out + ".yaml");
    const bool is_whole = source.starts_with('{');
    std::ofstream(file)
        << "source: " << (is_whole ? source : "{plugin: ros2, " + network + ", " + source + "}")
        << "\nodometry: {plugin: direct_sparse_stereo}\n"
           "place: {plugin: view_templates}\n"
           "cells: {plugin: bayesian_attractor}\nmap: {plugin: experience_map}\n"
        << (is_whole ? "" : "observers: [{plugin: ros2_publisher, every: 0.1, " + network + "}]\n");
    return {tolmanProgram().string(), "run", file.string(), "--out", (folder / out).string()};
  }
  int frames(const std::string& out) const {
    return readJson(folder / out / "run.json")["counters"]["frames"];
  }
};

/// A stereo clip as raw images of full size: a list for the peer, and the same messages as a bag.
struct Clip {
  fs::path list, bag;

  Clip(const fs::path& kitti, const fs::path& folder, int pairs)
      : list(folder / "messages.txt"), bag(folder / "clip.mcap") {
    std::ofstream out(list);
    std::vector<RosMessage> messages;
    const RosCamera left = camera(0);
    const RosCamera right = camera(-379.8145);
    addCamera(out, messages, "/left/camera_info", left);
    addCamera(out, messages, "/right/camera_info", right);
    for (int i = 0; i < pairs; ++i) {
      const std::int64_t stamp_ns = kFirst_ns + i * 100'000'000LL;
      std::array<char, 16> name{};
      std::snprintf(name.data(), name.size(), "%06d.png", i);
      for (const auto& [side, images] : {std::pair("left", "image_0"), {"right", "image_1"}}) {
        const cv::Mat image =
            cv::imread((kitti / images / name.data()).string(), cv::IMREAD_GRAYSCALE);
        const std::string pixels(image.datastart, image.dataend);
        const fs::path raw = folder / (std::string(side) + name.data() + ".raw");
        writeBytes(raw, pixels);
        const std::string topic = "/" + std::string(side) + "/image_rect";
        out << "image " << topic << " " << stamp_ns << " " << image.cols << " " << image.rows
            << " mono8 " << raw.string() << "\n";
        RosImage message{stamp_ns, static_cast<std::uint32_t>(image.cols),
                         static_cast<std::uint32_t>(image.rows), "mono8", pixels};
        messages.push_back({topic, "sensor_msgs/msg/Image", stamp_ns, imageMessage(message)});
      }
    }
    writeBytes(bag, mcapBytes(messages));
  }

 private:
  static RosCamera camera(double offset) {
    RosCamera made{1226, 370, "plumb_bob", {}, {}, {}, {}, 0};
    made.K = {707.0912, 0, 601.8873, 0, 707.0912, 183.1104, 0, 0, 1};
    made.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    made.P = {707.0912, 0, 601.8873, offset, 0, 707.0912, 183.1104, 0, 0, 0, 1, 0};
    return made;
  }
  static void addCamera(std::ostream& out, std::vector<RosMessage>& messages,
                        const std::string& topic, const RosCamera& camera) {
    out.precision(17);
    out << "camera " << topic << " " << kFirst_ns << " 1226 370 plumb_bob 0";
    for (const auto* values : {&camera.K, &camera.R, &camera.P}) {
      for (const double value : *values) out << " " << value;
    }
    out << "\n";
    messages.push_back({topic, "sensor_msgs/msg/CameraInfo", kFirst_ns, cameraInfoMessage(camera)});
  }
};

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("a clip that Fast DDS publishes gives the poses of the same clip in a bag",
          "[optional]") {
  const auto kitti = dataOrSkip("kitti_clips/06");
  if (!kitti || !ros2LiveOrSkip()) return;
  Robot robot;
  const Clip clip(*kitti, robot.folder, 30);
  robot.listen("heard.txt");
  robot.publish(clip.list, "reliable", "exit");
  const Finished live =
      run(robot.command("reliable: true, wait: 6, end_when_silent: true", "live"));
  INFO(live.err);
  REQUIRE(live.exit_code == 0);
  CHECK(robot.frames("live") == 30);
  const std::string last =
      "odometry odom tolman_camera " + std::to_string(kFirst_ns + 2'900'000'000);
  robot.waitFor("heard.txt", last, 1);
  CHECK(robot.lines("heard.txt", "odometry").size() == 30);
  CHECK(robot.lines("heard.txt", "tf map odom").size() == 30);
  CHECK(contains(robot.lines("heard.txt", "tf").back(), "tolman_camera tolman_camera_optical"));
  CHECK(contains(robot.lines("heard.txt", "map").back(), "experiences:"));
  CHECK(robot.lines("heard.txt", "path map").size() >= 1);
  CHECK(contains(robot.lines("heard.txt", "diagnostics").back(), "tracking frame="));
  CHECK(robot.lines("heard.txt", "odometry BAD").empty());

  const Finished recorded =
      run(robot.command("{plugin: ros_bag, path: " + clip.bag.string() + "}", "recorded"));
  INFO(recorded.err);
  REQUIRE(recorded.exit_code == 0);
  for (const char* file : {"odometry.tum", "trajectory.tum", "map.g2o"}) {
    CHECK(readText(robot.folder / "live" / file) == readText(robot.folder / "recorded" / file));
  }
}

TEST_CASE("late joiners get calibration and map, which were published before", "[optional]") {
  const auto kitti = dataOrSkip("kitti_clips/06");
  if (!kitti || !ros2LiveOrSkip()) return;
  Robot robot;
  const Clip clip(*kitti, robot.folder, 20);
  robot.publish(clip.list, "best_effort", "again");
  robot.start(robot.command("wait: 6, last: 150", "early"));
  robot.listen("first.txt");
  robot.waitFor("first.txt", "path map", 1);
  robot.listen("late.txt");
  robot.waitFor("late.txt", "map experiences:", 1);
  robot.waitFor("late.txt", "odometry", 1);
  const Finished late = run(robot.command("wait: 6, last: 9", "late"));
  INFO(late.err);
  CHECK(late.exit_code == 0);
  CHECK(robot.frames("late") == 10);
}

TEST_CASE("a publisher that ends, or is killed: what came is kept, and the error says what to do",
          "[optional]") {
  const auto kitti = dataOrSkip("kitti_clips/06");
  if (!kitti || !ros2LiveOrSkip()) return;
  struct Case {
    std::string then;
    std::string message;
  };
  for (const Case& c : {Case{"exit", "nobody publishes it any more; start the camera's node again"},
                        Case{"stay", "and its node has not signed off: it was killed, or hangs"}}) {
    Robot robot;
    const Clip clip(*kitti, robot.folder, 12);
    robot.listen("heard.txt");
    Process& camera = robot.publish(clip.list, "reliable", c.then);
    Process& tolman = robot.start(robot.command("reliable: true, wait: 4", "live"));
    robot.waitFor("heard.txt",
                  "odometry odom tolman_camera " + std::to_string(kFirst_ns + 1'100'000'000), 1);
    if (c.then == "stay") camera.signal(SIGKILL);
    const Finished finished = tolman.wait();
    INFO(finished.err);
    CHECK(finished.exit_code == 5);
    CHECK(contains(finished.err, c.message));
    CHECK(countOf(finished.err, "no image came on") == 1);
    CHECK(robot.frames("live") == 12);
  }
}

TEST_CASE("no publisher, a wrong topic, another delivery: one clear error each", "[optional]") {
  const auto kitti = dataOrSkip("kitti_clips/06");
  if (!kitti || !ros2LiveOrSkip()) return;
  const auto error = [](Robot& robot, const std::string& source) {
    const Finished finished = run(robot.command(source, "failed"));
    CHECK(finished.exit_code != 0);
    CHECK(countOf(finished.err, "\n") == 1);
    return finished.err;
  };
  Robot robot;
  CHECK(contains(error(robot, "wait: 0.5"),
                 "nobody publishes images; start the camera's node (`ros2 topic list`"));
  CHECK(contains(error(robot, "wait: 0.5, imu: /imu, left: /left/image_rect"),
                 "nobody publishes /left/image_rect"));
  const Clip clip(*kitti, robot.folder, 2);
  robot.publish(clip.list, "best_effort", "stay");
  CHECK(contains(error(robot, "left: /rear, wait: 3"),
                 "nobody publishes /rear; topics with images are: /left/image_rect, "
                 "/right/image_rect"));
  CHECK(contains(error(robot, "left: /left/camera_info, wait: 3"),
                 "topic /left/camera_info is of type sensor_msgs/msg/CameraInfo"));
  CHECK(contains(error(robot, "reliable: true, wait: 3"),
                 "its publisher does not send reliably; leave out reliable"));
}
