// SPDX-License-Identifier: BSD-3-Clause
// Live ROS 1 with a roscore on the loopback interface: ROS 1's Python modules publish a clip and
// receive the poses.
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "end_to_end/ros1_loopback.hpp"
#include "support/ros1_tool.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

constexpr std::int64_t kBegin = 1'700'000'000'000'000'000;

/// Publishes a clip, and notes what Tolman publishes.
struct Desk : Ros1Loopback {
  using Ros1Loopback::Ros1Loopback;

  /// Publishes images of the clip once somebody listens to all topics.
  void publish(const fs::path& clip, int count, const std::string& then) {
    tool({"publish", list(clip, count).string(), "20", then});
  }
  fs::path list(const fs::path& clip, int count) {
    const fs::path file = folder() / "messages.txt";
    std::ofstream out(file);
    out << "camera /front/camera_info 1000000000 1242 375 plumb_bob 0 721.5377 0 609.5593 0 "
           "721.5377 172.854 0 0 1 1 0 0 0 1 0 0 0 1 721.5377 0 609.5593 0 0 721.5377 172.854 0 0 "
           "0 1 0\n";
    for (int i = 0; i < count; ++i) {
      std::array<char, 16> name{};
      std::snprintf(name.data(), name.size(), "%06d.jpg", i);
      out << "compressed /front/image_rect/compressed " << kBegin + i * 100'000'000LL << " jpeg "
          << (clip / "image_0" / name.data()).string() << "\n";
    }
    return file;
  }
  /// Starts to note what comes, and waits until it does.
  void listen() {
    tool({"listen", "/tolman", heard().string()});
    waitFor("ready", 1);
  }
  fs::path heard() const { return folder() / "heard.txt"; }
  /// Lines that begin with the word.
  std::vector<std::string> lines(const std::string& word) const {
    std::vector<std::string> found;
    std::ifstream in(heard());
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with(word)) found.push_back(line);
    }
    return found;
  }
  void waitFor(const std::string& word, std::size_t count) const {
    for (int i = 0; i < 600 && lines(word).size() < count; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    REQUIRE(lines(word).size() >= count);
  }
  std::vector<std::string> runCommand(const std::string& source, const std::string& out) const {
    const fs::path file = folder() / (out + ".yaml");
    std::ofstream(file) << "source: " << source
                        << "\nodometry: {plugin: scanline}\nplace: {plugin: view_templates}\n"
                           "cells: {plugin: bayesian_attractor}\nmap: {plugin: experience_map}\n"
                           "observers: [{plugin: ros1_publisher, every: 0.1}]\n";
    return command(
        {tolmanProgram().string(), "run", file.string(), "--out", (folder() / out).string()});
  }
  int frames(const std::string& out) const {
    return readJson(folder() / out / "run.json")["counters"]["frames"];
  }
};

std::string lastLine(const fs::path& file) {
  std::string last;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) last = line;
  return last;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("a clip that is published gives the poses of the same clip in a bag", "[data]") {
  const auto clip = dataOrSkip("kitti_clips/03_left");
  if (!clip || !ros1LiveOrSkip()) return;
  Desk ros;
  ros.listen();
  ros.publish(*clip, 30, "exit");
  const Finished live =
      run(ros.runCommand("{plugin: ros1, wait: 4, end_when_silent: true}", "live"));
  INFO(live.out << live.err);
  REQUIRE(live.exit_code == 0);
  CHECK(ros.frames("live") == 30);
  // The listener may come to the topics a moment after the first frames.
  const std::string last = "pose map " + std::to_string(kBegin + 2'900'000'000);
  ros.waitFor(last, 1);
  ros.waitFor("map", 1);
  const std::size_t poses = ros.lines("pose").size();
  CHECK(poses >= 15);
  CHECK(poses <= 30);
  CHECK(ros.lines("tf map tolman_camera").size() >= 15);
  CHECK(contains(ros.lines("map").back(), "experiences:"));
  CHECK(ros.lines("path map").size() >= 1);
  std::istringstream heard(ros.lines(last).back().substr(last.size()));
  double x = 0;
  heard >> x;
  std::istringstream written(lastLine(ros.folder() / "live/odometry.tum"));
  std::array<double, 4> row{};  // time, and the camera's x, y, z
  for (double& value : row) written >> value;
  CHECK(x > 10);
  CHECK(x == Approx(row[3]).margin(0.5));

  const fs::path bag = ros.folder() / "clip.bag";
  REQUIRE(run(ros.command({"/usr/bin/python3", Desk::kTool, "bag", ros.list(*clip, 30).string(),
                           bag.string(), "lz4"}))
              .exit_code == 0);
  const Finished recorded =
      run(ros.runCommand("{plugin: ros_bag, path: " + bag.string() + "}", "recorded"));
  INFO(recorded.err);
  REQUIRE(recorded.exit_code == 0);
  for (const char* file : {"odometry.tum", "trajectory.tum", "map.g2o"}) {
    CHECK(readText(ros.folder() / "live" / file) == readText(ros.folder() / "recorded" / file));
  }
}

TEST_CASE("no roscore, no publisher, a wrong topic: one clear error each", "[data]") {
  const auto clip = dataOrSkip("kitti_clips/03_left");
  if (!clip || !ros1LiveOrSkip()) return;
  const auto error = [](Desk& ros, const std::string& source) {
    const Finished finished = run(ros.runCommand(source, "failed"));
    CHECK(finished.exit_code != 0);
    CHECK(count(finished.err, "\n") == 1);
    return finished.err;
  };
  Desk nobody(false);
  CHECK(contains(error(nobody, "{plugin: ros1, wait: 0.5}"),
                 "no roscore answers at " + nobody.uri() + "; start it (`roscore`)"));
  CHECK(contains(error(nobody, "{plugin: ros1, master: localhost}"),
                 "'localhost' is no URI of a roscore; write http://host:11311"));
  Desk ros;
  CHECK(contains(error(ros, "{plugin: ros1, wait: 0.5}"),
                 "nobody publishes images; start the camera's node"));
  ros.publish(*clip, 2, "stay");
  CHECK(contains(error(ros, "{plugin: ros1, left: /rear, wait: 3}"),
                 "nobody publishes /rear; topics with images are: /front/image_rect/compressed"));
  CHECK(contains(error(ros, "{plugin: ros1, left: /front/camera_info}"),
                 "topic /front/camera_info is of type sensor_msgs/CameraInfo"));
}

TEST_CASE("what is no roscore, or never answers, is reported and not waited for", "[optional]") {
  if (!ros1LiveOrSkip()) return;
  Desk desk(false);
  const auto address = [](int port) { return "http://127.0.0.1:" + std::to_string(port); };
  const auto error = [&](int port) {
    auto command = desk.runCommand("{plugin: ros1, master: '" + address(port) + "'}", "failed");
    command.insert(command.begin(), {"timeout", "40"});
    const Finished finished = run(command);
    CHECK(finished.exit_code == 5);
    return finished.err;
  };
  const int mute = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);  // nobody accepts
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof place;
  REQUIRE(::bind(mute, reinterpret_cast<sockaddr*>(&place), size) == 0);
  REQUIRE(::listen(mute, 5) == 0);
  REQUIRE(::getsockname(mute, reinterpret_cast<sockaddr*>(&place), &size) == 0);
  const int port = ntohs(place.sin_port);
  CHECK(contains(error(port), "a program listens at " + address(port) +
                                  " and did not answer within 5 s; the roscore hangs"));
  ::close(mute);
  Process other(
      {"/usr/bin/python3", "-m", "http.server", "--bind", "127.0.0.1", std::to_string(port)},
      desk.folder());
  std::string told;
  for (int i = 0; i < 50 && !contains(told, "is no roscore"); ++i) told = error(port);
  other.signal(SIGKILL);
  (void)other.wait();
  CHECK(contains(told, "what answers at " + address(port) + " is no roscore; start it"));
}

TEST_CASE("a camera that ends, one that hangs, a roscore that is gone: what came is kept",
          "[data]") {
  const auto clip = dataOrSkip("kitti_clips/03_left");
  if (!clip || !ros1LiveOrSkip()) return;
  const std::string source = "{plugin: ros1, wait: 4}";
  struct Case {
    std::string then;
    bool core_ends;
    std::string message;
  };
  for (const Case& c :
       {Case{"exit", false, "nobody publishes it any more; start the camera's node again"},
        Case{"stay", false, "though its node runs; the camera was unplugged, or hangs"},
        Case{"stay", true, "is gone; start both again, and go on with --continue"}}) {
    Desk ros;
    ros.listen();
    ros.publish(*clip, 12, c.then);
    fs::create_directories(ros.folder() / "tolman");
    Process live(ros.runCommand(source, "live"), ros.folder() / "tolman");
    ros.waitFor("pose map " + std::to_string(kBegin + 1'100'000'000), 1);
    if (c.core_ends) ros.endCore();
    const Finished finished = live.wait();
    INFO(finished.err);
    CHECK(finished.exit_code == 5);
    CHECK(contains(finished.err, c.message));
    CHECK(count(finished.err, "no image came on") == 1);
    CHECK(ros.frames("live") == 12);
    CHECK(run({tolmanProgram().string(), "report", (ros.folder() / "live").string()}).exit_code ==
          0);
  }
}
