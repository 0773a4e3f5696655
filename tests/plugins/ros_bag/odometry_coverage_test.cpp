// SPDX-License-Identifier: BSD-3-Clause
// Odometry that does not cover the images: frames without a measured motion are told as lost, and a
// topic that measures none is refused.
#include "odometry_coverage.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "ros1_case.hpp"

namespace tolman::ros_bag {
namespace {

using Kind = OdometryCoverage::Kind;

constexpr std::int64_t kMs = 1'000'000;

/// 40 images, every 50 ms, and odometry at 1 m/s every 20 ms where `sent` says so.
template <class Sent>
std::vector<test::RosMessage> driveWith(const Sent& sent, std::int64_t later_ns = 0) {
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < 40; ++i) messages.push_back(greyImage("/camera", i));
  for (int i = 0; i <= 100; ++i) {
    if (!sent(20 * i)) continue;
    const std::int64_t stamp = stampOf(0) + 20 * kMs * i + later_ns;
    messages.push_back(
        {"/odom", std::string(kOdometry), stamp, test::odometryMessage(stamp, 0.02 * i, 0, 0)});
  }
  return messages;
}

float valueOf(const Frame& frame, const std::string& name) {
  for (const NamedArray& array : frame.sensors) {
    if (array.name == name) return array.values.at(0);
  }
  return -1;
}

std::vector<std::int64_t> lostFrames(const Played& played) {
  std::vector<std::int64_t> lost;
  for (const Frame& frame : played.frames) {
    if (valueOf(frame, "motion.lost") == 1) lost.push_back(frame.frame);
  }
  return lost;
}

std::vector<std::int64_t> numbers(std::int64_t first, std::int64_t last) {
  std::vector<std::int64_t> all;
  for (std::int64_t i = first; i <= last; ++i) all.push_back(i);
  return all;
}

/// That `dataset check` and the log of the run both have one warning with this text.
void checkToldOnce(Played& played, const std::string& text) {
  CAPTURE(text, played.context.log, played.findings());
  const auto has = [&](const std::string& line) { return line.find(text) != std::string::npos; };
  CHECK(std::ranges::count_if(played.context.log, has) == 1);
  CHECK(std::ranges::count_if(played.findings(), [&](const std::string& finding) {
          return finding.starts_with("warning") && has(finding);
        }) == 1);
}

}  // namespace

TEST_CASE("kinds of motions by the times of the messages") {
  const OdometryCoverage coverage({0, 100 * kMs, 200 * kMs, 300 * kMs, 1400 * kMs, 1500 * kMs});
  CHECK(coverage.kindOf(0, 300 * kMs) == Kind::Measured);
  CHECK(coverage.kindOf(1500 * kMs, 1400 * kMs) == Kind::Measured);
  CHECK(coverage.kindOf(250 * kMs, 301 * kMs) == Kind::InHole);
  CHECK(coverage.kindOf(500 * kMs, 600 * kMs) == Kind::InHole);
  CHECK(coverage.kindOf(1410 * kMs, 1399 * kMs) == Kind::InHole);
  CHECK(coverage.kindOf(-1, 100 * kMs) == Kind::Outside);
  CHECK(coverage.kindOf(1501 * kMs, 1450 * kMs) == Kind::Outside);
  CHECK(OdometryCoverage().kindOf(0, 1) == Kind::Outside);
  // Ten periods, or 0.5 s, are no hole; nor is a slow topic.
  const auto middle = [](std::vector<std::int64_t> stamps_ms) {
    for (std::int64_t& stamp : stamps_ms) stamp *= kMs;
    const std::int64_t end = stamps_ms.back();
    return OdometryCoverage(std::move(stamps_ms)).kindOf(end - 2 * kMs, end - kMs);
  };
  CHECK(middle({0, 100, 200, 300, 1300}) == Kind::Measured);
  CHECK(middle({0, 10, 20, 30, 530}) == Kind::Measured);
  CHECK(middle({0, 10, 20, 30, 531}) == Kind::InHole);
  CHECK(middle({0, 2000, 4000}) == Kind::Measured);
  CHECK(middle({0, 0, 0, 0, 100, 200, 1000}) == Kind::Measured);  // repeated stamps
}

TEST_CASE("odometry that ends before the images, or begins after them") {
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "end.db3", driveWith([](int ms) { return ms <= 1000; }));
  Played end(folder.path() / "end.db3");
  CHECK(end.message.empty());
  CHECK(lostFrames(end) == numbers(21, 39));
  CHECK(valueOf(end.frames.at(20), "motion.planar") == Approx(0.05));
  checkToldOnce(
      end,
      "/odom: its messages are from 1749315324.903 s to 1749315325.903 s, the images "
      "from 1749315324.903 s to 1749315326.853 s: 19 of 40 frames have no measured motion");
  std::vector<ArrayInfo> arrays;
  REQUIRE(end.source.describe(arrays).isOk());
  CHECK(arrays.size() == end.frames[0].sensors.size());
  test::writeDb3(folder.path() / "begin.db3", driveWith([](int ms) { return ms >= 1000; }));
  Played begin(folder.path() / "begin.db3");
  CHECK(lostFrames(begin) == numbers(1, 20));
  checkToldOnce(begin, "20 of 40 frames have no measured motion");
  const Played part(folder.path() / "begin.db3", {{"first", std::int64_t{20}}});
  CHECK(part.context.log.empty());
  CHECK(lostFrames(part).empty());
}

TEST_CASE("odometry with a hole") {
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "a.db3",
                 driveWith([](int ms) { return ms <= 500 || ms >= 1300; }));
  Played played(folder.path() / "a.db3");
  CHECK(lostFrames(played) == numbers(11, 26));
  checkToldOnce(played,
                "/odom: no message for 0.800 s from 1749315325.403 s on (usual period 0.020 s): "
                "16 of 40 frames have no measured motion");
  CHECK(valueOf(played.frames.at(15), "motion.planar") == Approx(0.05));  // a straight line
  test::writeDb3(folder.path() / "b.db3", driveWith([](int ms) { return ms <= 500 || ms >= 900; }));
  const Played bridged(folder.path() / "b.db3");
  CHECK(bridged.context.log.empty());
  CHECK(valueOf(bridged.frames.at(15), "motion.lost") == -1);
}

TEST_CASE("odometry whose clock is another than that of the images") {
  const test::TemporaryFolder folder;
  const auto all = [](int) { return true; };
  test::writeBytes(folder.path() / "a.mcap", test::mcapBytes(driveWith(all, 50'000'000'000)));
  const std::string text =
      "/odom: no motion between the images is measured: its messages are from 1749315374.903 s to "
      "1749315376.903 s, the images from 1749315324.903 s to 1749315326.853 s";
  Played stopped(folder.path() / "a.mcap");
  CHECK_THAT(stopped.message, Catch::Contains(text));
  CHECK(stopped.source.reset().code() == StatusCode::InvalidInput);
  CHECK(std::ranges::any_of(stopped.findings(), [&](const std::string& finding) {
    return finding.starts_with("error") && finding.find(text) != std::string::npos;
  }));
  Played skipped(folder.path() / "a.mcap", {{"on_corrupt", std::string("skip")}});
  CHECK(skipped.message.empty());
  CHECK(skipped.frames.size() == 40);
  CHECK(valueOf(skipped.frames.at(5), "motion.planar") == -1);
  checkToldOnce(skipped, text);
}

TEST_CASE("orientations that are no rotations are damaged messages") {
  const auto zeroed = [](std::string bytes) {
    const auto at = bytes.size() - (36 + 6 + 36 + 4) * sizeof(double);
    return bytes.replace(at, 4 * sizeof(double), 4 * sizeof(double), '\0');
  };
  const std::string sound = test::odometryMessage(stampOf(3), 3, -2, 1);
  CHECK(readOdometry({asBytes(sound), Encoding::Cdr}));
  CHECK_FALSE(readOdometry({asBytes(zeroed(sound)), Encoding::Cdr}));
  auto messages = driveWith([](int) { return true; });
  messages.at(47).bytes = zeroed(messages.at(47).bytes);
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "a.db3", messages);
  CHECK_THAT(Played(folder.path() / "a.db3").message,
             Catch::Contains("1 messages of other sensors are damaged, first of /odom with the "
                             "stamp " +
                             std::to_string(stampOf(0) + 140 * kMs) + " ns (message 7)"));
  const Played skipped(folder.path() / "a.db3", {{"on_corrupt", std::string("skip")}});
  CHECK(skipped.frames.size() == 40);
  CHECK(skipped.context.log.size() == 1);
}

TEST_CASE("orientations that are no rotations, in ROS 1") {
  const auto readsWith = [](double w) {
    std::string bytes = rawNumber(std::uint32_t{0}) + rawNumber(std::uint32_t{5}) +
                        rawNumber(std::uint32_t{0}) + ros1Text("odom") + ros1Text("base");
    for (const double value : {1.0, 2.0, 0.0, 0.0, 0.0, 0.0, w}) bytes += rawNumber(value);
    bytes += std::string(78 * sizeof(double), '\0');
    return readOdometry({asBytes(bytes), Encoding::Ros1}).has_value();
  };
  CHECK(readsWith(1));
  CHECK(readsWith(-0.999));
  CHECK_FALSE(readsWith(0));
  CHECK_FALSE(readsWith(0.5));
  CHECK_FALSE(readsWith(2));
}

}  // namespace tolman::ros_bag
