// SPDX-License-Identifier: BSD-3-Clause
// True poses of a topic, in bags of ROS 1 and 2.
#include "true_poses.hpp"

#include <catch2/catch.hpp>

#include "bag_case.hpp"
#include "ros1_case.hpp"
#include "tolman/geometry.hpp"

namespace tolman::ros_bag {
namespace {

constexpr std::int64_t kMs = 1'000'000;

/// The pose of the body at image `index`, which may be between two of them.
Eigen::Isometry3d bodyAt(double index) {
  Vector6d twist;
  twist << 0.1 * index, -0.02 * index, 0.05 * index, 0.01 * index, 0.03 * index, -0.02 * index;
  return Eigen::Translation3d(7, 8, 9) * expSe3(twist);
}

std::vector<double> numbersOf(const Eigen::Isometry3d& T) {
  const Eigen::Vector3d p = T.translation();
  const Eigen::Quaterniond q(T.linear());
  return {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
}

std::string typeOf(const std::string& name) {
  for (const std::string_view type : kPoseTypes) {
    if (type.ends_with("/" + name)) return std::string(type);
  }
  FAIL("no type " << name);
  return "";
}

/// A message of any of these types; one of tf has another transform before.
std::string poseMessage(const std::string& type, std::int64_t stamp_ns,
                        const Eigen::Isometry3d& T) {
  test::CdrWriter message;
  if (type == "TFMessage") {
    message.number(std::uint32_t{2}).header(stamp_ns, "body").text("camera");
    message.numbers(numbersOf(Eigen::Isometry3d::Identity()));
  }
  message.header(stamp_ns, "map");
  if (type == "TFMessage" || type == "TransformStamped" || type == "Odometry") message.text("body");
  message.numbers(numbersOf(T));
  const std::size_t rest = type == "Odometry" ? 36 + 6 + 36 : type.starts_with("PoseWith") ? 36 : 0;
  return message.numbers(std::vector<double>(rest, 0)).bytes();
}

/// Ten images, and the body's poses at 40 Hz from the second on, without those from `gap` images on
/// for three images; each stamp is a little off those of the images.
std::vector<test::RosMessage> walk(const std::string& type, int gap = 100) {
  std::vector<test::RosMessage> messages;
  for (int i = 0; i < 10; ++i) messages.push_back(greyImage("/camera/image", i));
  for (int half = 0; half < 18; ++half) {
    const double at = 0.9 + 0.5 * half;
    if (at > gap && at < gap + 3) continue;
    const std::int64_t stamp = stampOf(0) + std::llround(at * 50) * kMs;
    messages.push_back(
        {"/truth", typeOf(type), stamp + 20 * kMs, poseMessage(type, stamp, bodyAt(at))});
  }
  return messages;
}

ParameterValues truthIs(const std::string& text) { return {{"truth", text}}; }

void checkPath(const Played& played) {
  INFO(played.message);
  REQUIRE(played.message.empty());
  REQUIRE(played.frames.size() == 10);
  CHECK(played.info.has_truth);
  CHECK_FALSE(played.frames[0].has_truth);  // the first true pose is later
  for (int i = 1; i < 10; ++i) {
    const Frame& frame = played.frames[static_cast<std::size_t>(i)];
    REQUIRE(frame.has_truth);
    CHECK(frame.T_world_camera_truth.isApprox(bodyAt(0.9).inverse() * bodyAt(i), 1e-4));
  }
}

}  // namespace

TEST_CASE("each type of pose becomes the truth, between two of them, in both formats of ROS 2") {
  const test::TemporaryFolder folder;
  const std::string type = GENERATE("Odometry", "PoseStamped", "PoseWithCovarianceStamped",
                                    "TransformStamped", "TFMessage");
  CAPTURE(type);
  const auto values = truthIs(type == "TFMessage" ? "/truth map body" : "/truth");
  test::writeBytes(folder.path() / "bag.mcap", test::mcapBytes(walk(type), {"zstd"}));
  const Played mcap(folder.path() / "bag.mcap", values);
  checkPath(mcap);
  CHECK(mcap.findings().empty());
  std::vector<ArrayInfo> arrays;
  REQUIRE(mcap.source.describe(arrays).isOk());
  CHECK(arrays.empty());  // an Odometry that is the truth is no measured motion
  test::writeDb3(folder.path() / "bag.db3", walk(type));
  checkPath(Played(folder.path() / "bag.db3", values));
}

TEST_CASE("a truth of ROS 1, with transforms of its early tf") {
  std::string tf, poses;
  for (int half = 0; half < 18; ++half) {
    const double at = 0.9 + 0.5 * half;
    const std::int64_t stamp = stampOf(0) + std::llround(at * 50) * kMs;
    std::string header =
        rawNumber(std::uint32_t{0}) + rawNumber(static_cast<std::uint32_t>(stamp / 1'000'000'000)) +
        rawNumber(static_cast<std::uint32_t>(stamp % 1'000'000'000)) + ros1Text("map");
    std::string pose;
    for (const double number : numbersOf(bodyAt(at))) pose += rawNumber(number);
    tf += ros1Message(1, 5, rawNumber(std::uint32_t{1}) + header + ros1Text("body") + pose);
    poses += ros1Message(2, 5, header + pose);
  }
  std::string images;
  for (int i = 0; i < 10; ++i) {
    const std::string cdr = greyImage("/camera/image", i).bytes;
    // As CDR, but for the sequence number, texts without zero, and no padding.
    const std::string data = rawNumber(std::uint32_t{0}) + cdr.substr(4, 8) + ros1Text("camera") +
                             rawNumber(std::uint32_t{6}) + rawNumber(std::uint32_t{8}) +
                             ros1Text("mono8") + std::string(1, '\0') +
                             rawNumber(std::uint32_t{8}) + ros1Text(std::string(48, 'x'));
    images += ros1Message(0, 5, data);
  }
  const test::TemporaryFolder folder;
  test::writeBytes(
      folder.path() / "walk.bag",
      ros1Start(0) + ros1Chunk(ros1Connection(0, "/camera/image", "sensor_msgs/Image") + images +
                               ros1Connection(1, "/tf", "tf/tfMessage") + tf +
                               ros1Connection(2, "/pose", "geometry_msgs/PoseStamped") + poses));
  checkPath(Played(folder.path() / "walk.bag", truthIs("/tf map body")));
  checkPath(Played(folder.path() / "walk.bag", truthIs("/pose")));
}

TEST_CASE("no truth across a gap; a transform is named; a truth of another time is reported") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "bag.mcap";
  test::writeBytes(file, test::mcapBytes(walk("TFMessage", 4)));
  const Played gap(file, truthIs("/truth map body"));
  REQUIRE(gap.frames.size() == 10);
  std::string known;
  for (const Frame& frame : gap.frames) known += frame.has_truth ? '1' : '0';
  CHECK(known == "0111000011");
  CHECK(
      Played(file, truthIs("/truth map camera")).message ==
      "truth: /truth has no pose of 'camera' in 'map'; name topic, frame and child frame, one of: "
      "body camera, map body");
  CHECK_THAT(Played(file, truthIs("/camera/image")).message,
             Catch::Contains("set truth to one of: /truth"));
  std::vector<test::RosMessage> messages = walk("PoseStamped");
  messages.push_back(greyImage("/late/image", 9000));
  messages.push_back(greyImage("/late/image", 9001));
  test::writeBytes(file, test::mcapBytes(messages));
  ParameterValues values = truthIs("/truth");
  values["left"] = std::string("/late/image");
  const Played late(file, values);
  CHECK_FALSE(late.info.has_truth);
  REQUIRE(late.findings().size() == 1);
  CHECK_THAT(late.findings()[0],
             Catch::StartsWith("error /truth: has no true pose at the time of any image"));
}

}  // namespace tolman::ros_bag
