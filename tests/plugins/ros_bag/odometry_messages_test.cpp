// SPDX-License-Identifier: BSD-3-Clause
// Odometry messages that contradict each other or themselves.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <functional>

#include "bag_case.hpp"

namespace tolman::ros_bag {
namespace {

constexpr std::int64_t kPeriod_ns = 20'000'000;

/// 80 images in 4 s, and odometry every 20 ms. `write` gives the message of a time (s) and stamp.
std::vector<test::RosMessage> driveWith(
    const std::function<std::string(double, std::int64_t)>& write) {
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < 80; ++i) messages.push_back(greyImage("/camera", i));
  for (int i = 0; i <= 200; ++i) {
    const std::int64_t stamp = stampOf(0) + kPeriod_ns * i;
    messages.push_back({"/odom", std::string(kOdometry), stamp, write(0.02 * i, stamp)});
  }
  return messages;
}

bool isTold(const Played& played, const std::string& text) {
  return std::ranges::any_of(played.context.log, [&](const std::string& line) {
    return line.find(text) != std::string::npos;
  });
}

Played playedOf(const test::TemporaryFolder& folder, const std::vector<test::RosMessage>& messages,
                const ParameterValues& values = {}) {
  std::filesystem::remove(folder.path() / "a.db3");
  test::writeDb3(folder.path() / "a.db3", messages);
  return Played(folder.path() / "a.db3", values);
}

}  // namespace

TEST_CASE("poses in cm with velocities in m/s are told, others are not") {
  const test::TemporaryFolder folder;
  const double scale = GENERATE(1.0, 100.0, 1000.0);
  const double speed = GENERATE(0.0, 0.6);  // 0: not measured
  CAPTURE(scale, speed);
  const Played played =
      playedOf(folder, driveWith([&](double time, std::int64_t stamp) {
                 return test::odometryMessage(stamp, scale * 0.6 * time, 0, 0, speed);
               }));
  CHECK(played.message.empty());
  CHECK(isTold(played, "are both in m and m/s?") == (scale > 1 && speed > 0));
}

TEST_CASE("headings that contradict the angular velocities are told") {
  const test::TemporaryFolder folder;
  // A circle of 20 m at 12 m/s, and what is written of its headings.
  const double factor = GENERATE(1.0, -1.0, 0.0);
  const bool measured = GENERATE(true, false);
  CAPTURE(factor, measured);
  const Played played = playedOf(
      folder, driveWith([&](double time, std::int64_t stamp) {
        const double angle = 0.6 * time;
        return test::odometryMessage(stamp, 20 * std::sin(angle), 20 * (1 - std::cos(angle)),
                                     factor * angle, measured ? 12 : 0, "odom", measured ? 0.6 : 0);
      }));
  CHECK(played.message.empty());
  CHECK(played.context.log.empty() == (factor == 1 || !measured));
}

TEST_CASE("orientations that do not turn with the robot are told") {
  const test::TemporaryFolder folder;
  const Played played = playedOf(folder, driveWith([](double time, std::int64_t stamp) {
                                   return test::odometryMessage(stamp, time, 0, 0, 1, "odom", 0.6);
                                 }));
  CHECK(isTold(played, "its poses turn by 0 degrees, and its angular velocities by"));
}

TEST_CASE("a robot that drives backwards by its velocities and forwards by its poses is told") {
  const test::TemporaryFolder folder;
  const double speed = GENERATE(12.0, -12.0, 24.0);
  CAPTURE(speed);
  const Played played = playedOf(folder, driveWith([&](double time, std::int64_t stamp) {
                                   return test::odometryMessage(stamp, 12 * time, 0, 0, speed);
                                 }));
  CHECK(isTold(played, "move in other directions than its velocities") == (speed < 0));
  CHECK(isTold(played, "are both in m and m/s?") == (speed > 12));
}

TEST_CASE("velocities in the frame of the poses, as simulators write them, are no doubt") {
  const test::TemporaryFolder folder;
  const Played played = playedOf(folder, driveWith([](double time, std::int64_t stamp) {
                                   return test::odometryMessage(stamp, 12 * time, 0, 3, 12);
                                 }));
  CHECK(played.context.log.empty());
}

TEST_CASE("a robot that stands, with noise in its odometry, has no doubtful unit") {
  const test::TemporaryFolder folder;
  const Played played =
      playedOf(folder, driveWith([&](double time, std::int64_t stamp) {
                 const double noise = 0.001 * std::sin(1e4 * time);
                 return test::odometryMessage(stamp, noise, 0, 0, std::abs(noise));
               }));
  CHECK(played.message.empty());
  CHECK(played.context.log.empty());
}

TEST_CASE("poses that begin again in the middle are told as such") {
  const test::TemporaryFolder folder;
  const bool again = GENERATE(true, false);
  const double speed = GENERATE(3.0, 0.1);
  const std::string jump = speed == 3 ? "5.94" : "0.198";
  const Played played = playedOf(folder, driveWith([&](double time, std::int64_t stamp) {
                                   const double since = again && time > 2 ? time - 2 : time;
                                   return test::odometryMessage(stamp, speed * since, 0, 0, speed);
                                 }));
  CHECK(played.message.empty());
  CHECK(isTold(played, "its position is back where it began, " + jump + " m in one step") == again);
  CHECK_FALSE(isTold(played, "are both in m and m/s?"));
}

TEST_CASE("poses in another frame are refused, or left out") {
  const test::TemporaryFolder folder;
  const auto messages = driveWith([&](double time, std::int64_t stamp) {
    const bool other = static_cast<int>(std::round(time / 0.02)) % 2 == 1;
    return test::odometryMessage(stamp, time, other ? 2 : 0, 0, 0, other ? "map" : "odom");
  });
  const std::string text =
      " is a pose in the frames 'map, base', and the first message in 'odom, base', and 99 more "
      "like it";
  CHECK_THAT(playedOf(folder, messages).message, Catch::Contains(text));
  const Played skipped = playedOf(folder, messages, {{"on_corrupt", std::string("skip")}});
  CHECK(skipped.message.empty());
  CHECK(isTold(skipped, text));
  for (const NamedArray& array : skipped.frames.at(3).sensors) {
    if (array.name == "motion.planar") CHECK(array.values.at(1) == Approx(0).margin(1e-6));
  }
}

TEST_CASE("two poses of one time are refused, and times of recording are told") {
  const test::TemporaryFolder folder;
  auto messages = driveWith(
      [](double time, std::int64_t stamp) { return test::odometryMessage(stamp, time, 0, 0); });
  messages.push_back(
      {"/odom", std::string(kOdometry), stampOf(0), test::odometryMessage(stampOf(0), 5, 0, 0)});
  CHECK_THAT(playedOf(folder, messages).message,
             Catch::StartsWith("/odom: messages 0 and 201 (counted from 0) have the time ") &&
                 Catch::Contains("and different contents"));
  const Played without = playedOf(folder, driveWith([](double time, std::int64_t) {
                                    return test::odometryMessage(0, time, 0, 0);
                                  }));
  CHECK(without.message.empty());
  CHECK(isTold(without, "/odom: no message has a time in its header"));
}

}  // namespace tolman::ros_bag
