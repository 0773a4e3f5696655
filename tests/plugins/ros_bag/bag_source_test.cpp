// SPDX-License-Identifier: BSD-3-Clause
// Frames of valid bags: both formats, pairs, orders, calibration, split recordings.
#include "bag_source.hpp"

#include <catch2/catch.hpp>

#include "bag_case.hpp"

namespace tolman::ros_bag {

TEST_CASE("a pair from either format, in every order") {
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "a.db3", pairMessages(5, 1'000'000));
  test::writeBytes(folder.path() / "a.mcap", test::mcapBytes(pairMessages(5, 1'000'000), {"zstd"}));
  for (const char* name : {"a.db3", "a.mcap"}) {
    Played played(folder.path() / name);
    CHECK(played.message.empty());
    REQUIRE(played.frames.size() == 5);
    CHECK(played.info.frames == 5);
    CHECK(played.info.description ==
          "ROS 2 bag, 5 stereo pairs of /left/image_rect and "
          "/right/image_rect, 8x6 px");
    CHECK(played.info.rig.pinhole.fx == 7);
    CHECK(played.info.rig.baseline == Approx(0.12));
    for (int i = 0; i < 5; ++i) {
      const Frame& frame = played.frames[static_cast<std::size_t>(i)];
      CHECK(frame.stamp_ns == stampOf(i));
      CHECK(frame.left.row(5)[7] == 10 * i);
      CHECK(frame.right.row(0)[0] == 100 + 10 * i);
    }
    Played backward(folder.path() / name, {{"order", std::string("backward")},
                                           {"first", std::int64_t{1}},
                                           {"step", std::int64_t{2}}});
    REQUIRE(backward.frames.size() == 2);
    CHECK(backward.frames[0].left.row(0)[0] == 30);
    CHECK(backward.frames[1].source_index == 1);
  }
}

TEST_CASE("reading a bag is cancelled within its file, not at its end") {
  struct Third : Cancellation {
    bool requested() const override { return ++asked >= 3; }
    mutable int asked = 0;
  };
  struct NoFindings : FindingCollector {
    void add(Finding) override {}
  };
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "a.db3", pairMessages(5));
  test::writeBytes(folder.path() / "a.mcap", test::mcapBytes(pairMessages(5), {"zstd"}));
  for (const char* name : {"a.db3", "a.mcap"}) {
    const Third cancellation;
    NoFindings findings;
    const Result<Bag> bag = Bag::open(folder.path() / name, cancellation, findings);
    REQUIRE_FALSE(bag.isOk());
    CHECK(bag.status().code() == StatusCode::Cancelled);
    CHECK(cancellation.asked == 3);
  }
}

TEST_CASE("a camera that changes within a bag is refused, unless the calibration is given") {
  const test::TemporaryFolder folder;
  std::vector<test::RosMessage> messages = pairMessages(4);
  messages.push_back(cameraInfo("/left/camera_info", test::plainCamera(8, 6, 7, 0)));
  test::writeDb3(folder.path() / "same.db3", messages);
  CHECK(Played(folder.path() / "same.db3").message.empty());
  messages.push_back(cameraInfo("/right/camera_info", test::plainCamera(8, 6, 3.5, 0.12)));
  test::writeDb3(folder.path() / "other.db3", messages);
  CHECK(Played(folder.path() / "other.db3").message ==
        "/right/camera_info: a later message has another camera matrix than the first; cut the bag "
        "there, or give pinhole and baseline");
  CHECK(
      Played(folder.path() / "other.db3", {{"pinhole", std::vector<double>{7}}, {"baseline", 0.12}})
          .message.empty());
}

TEST_CASE("a recording in several files is one") {
  const test::TemporaryFolder folder;
  const auto all = pairMessages(4);
  const auto half = all.begin() + 6;
  test::writeBytes(folder.path() / "x_0.mcap", test::mcapBytes({all.begin(), half}, {"lz4"}));
  test::writeDb3(folder.path() / "x_1.db3", {half, all.end()});
  test::writeBytes(
      folder.path() / "metadata.yaml",
      "rosbag2_bagfile_information:\n  relative_file_paths:\n    - x_0.mcap\n    - x_1.db3\n");
  const Played played(folder.path());
  CHECK(played.message.empty());
  REQUIRE(played.frames.size() == 4);
  CHECK(played.frames[3].right.row(0)[0] == 130);
}

TEST_CASE("raw images are offered for rectification") {
  std::vector<test::RosMessage> messages;
  test::RosCamera camera = test::plainCamera(8, 6, 7, 0);
  camera.D = {0.1, 0, 0, 0, 0};
  messages.push_back(cameraInfo("/camera/camera_info", camera));
  messages.push_back(greyImage("/camera/image_raw", 0));
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "a.db3", messages);
  Played played(folder.path());
  CHECK_FALSE(played.info.rig.calibrated);
  RawRig raw;
  REQUIRE(played.source.rawRig(raw).isOk());
  REQUIRE(raw.cameras.size() == 1);
  CHECK(raw.cameras[0].distortion[0] == 0.1);
  // Numbers of the configuration stand in place of the messages.
  Played numbers(folder.path(), {{"pinhole", std::vector<double>{9}}});
  CHECK(numbers.info.rig.pinhole.fx == 9);
  REQUIRE(numbers.source.rawRig(raw).isOk());
  CHECK(raw.cameras.empty());
}

TEST_CASE("a pair without calibration, and how it is used") {
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "a.db3",
                 {greyImage("/cam0/image", 0), greyImage("/cam1/image", 0)});
  CHECK(Played(folder.path()).message ==
        "there is no CameraInfo beside /cam0/image and /cam1/image; set left_info and right_info, "
        "give pinhole and baseline, or set mono: true");
  CHECK(Played(folder.path(), {{"mono", true}}).frames.size() == 1);
  const Played numbers(folder.path(), {{"pinhole", std::vector<double>{7}}, {"baseline", 0.1}});
  CHECK(numbers.info.rig.isStereo());
  CHECK(Played(folder.path(), {{"baseline", 0.1}}).message ==
        "baseline is given without pinhole; give both");
}

TEST_CASE("notes list the topics and their use") {
  const test::TemporaryFolder folder;
  test::writeDb3(folder.path() / "a.db3", pairMessages(3));
  const Played played(folder.path());
  const auto& notes = played.context.findings;
  REQUIRE(notes.size() == 5);  // four topics, and what was decided
  CHECK(notes[1].where == "/left/image_rect");
  CHECK(notes[1].message ==
        "sensor_msgs/msg/Image, 3 messages at 20 Hz, 0.0003 MB, 8x6 mono8, used as left");
  CHECK(notes[4].message == "is taken as rectified");
}

}  // namespace tolman::ros_bag
