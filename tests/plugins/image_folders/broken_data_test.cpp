// SPDX-License-Identifier: BSD-3-Clause
// Broken sequences: the messages, before frame 0 or at the frame; all problems are reported.
#include <catch2/catch.hpp>

#include "data_folder.hpp"
#include "kitti_source.hpp"

namespace tolman::image_folders {
namespace {

/// The message of configure(), or else of the frame that fails.
std::string failure(const DataFolder& data, ParameterValues values = {}) {
  KittiSource source;
  if (values.find("path") == values.end()) values["path"] = data.path().string();
  std::string message = configure(source, std::move(values));
  if (message.empty()) readAll(source, message);
  return data.anonymous(message);
}

std::vector<std::string> findings(const DataFolder& data) {
  KittiSource source;
  (void)configure(source, {{"path", data.path().string()}});
  std::vector<std::string> texts = inspect(source);
  for (std::string& text : texts) text = data.anonymous(text);
  return texts;
}

const std::string kRemedy = "; copy or record it again, or leave it out by on_corrupt: skip";

}  // namespace

TEST_CASE("the wrong folder") {
  const DataFolder data;
  CHECK(failure(data, {{"path", data.path("no").string()}}) ==
        "DATA/no: is no folder; set path to a sequence, such as .../sequences/06");
  CHECK(failure(data, {{"path", data.path("image_0").string()}}) ==
        "DATA/image_0: has neither image_0 nor image_2; set path to a sequence, such as "
        ".../sequences/06, or take the source of another layout (`tolman init` finds it)");
}

TEST_CASE("problems that are found before frame 0") {
  const DataFolder data;
  SECTION("missing right image") {
    data.remove("image_1/000002.png");
    CHECK(failure(data) ==
          "DATA/image_1: has no 000002, the partner of image_0/000002.png; restore it, or remove "
          "the partner");
  }
  SECTION("empty calibration") {
    data.write("calib.txt", "");
    CHECK(failure(data) == "DATA/calib.txt: is empty; restore it");
  }
  SECTION("missing calibration") {
    data.remove("calib.txt");
    CHECK(failure(data) == "DATA/calib.txt: is missing; restore it, or correct the path");
  }
  SECTION("swapped cameras") {
    data.write("calib.txt", matrixLine("P0", 0) + matrixLine("P1", 25));
    CHECK(failure(data).starts_with("DATA/calib.txt:2: baseline is -0.5000 m: the right camera"));
  }
  SECTION("the calibration of larger images") {
    data.write("calib.txt", "P0: 700 0 600 0 0 700 180 0 0 0 1 0\n");
    CHECK(failure(data, {{"mono", true}}) ==
          "DATA/calib.txt: principal point (600.0, 180.0) is outside of the 64x48 image; give the "
          "calibration of these images");
  }
  SECTION("times going back") {
    data.write("times.txt", "0.0\n0.2\n0.1\n0.3\n");
    CHECK(failure(data) == "DATA/times.txt:3: time goes back by 0.100000 s; sort the data");
  }
  SECTION("no times") {
    data.remove("times.txt");
    CHECK(failure(data) ==
          "DATA/times.txt: is missing; restore it, or set rate to the frames a second");
  }
  SECTION("too few times") {
    data.write("times.txt", "0.0\n0.2\n0.3\n");
    CHECK(failure(data) ==
          "DATA/times.txt: has 3 entries, but there are 4 images; one line per image is needed");
  }
  SECTION("NaN in poses") {
    std::string poses = data.read("poses.txt");
    data.write("poses.txt", poses.replace(poses.find("2.5"), 3, "nan"));
    CHECK(failure(data).starts_with("DATA/poses.txt:3: 'nan' is no finite number; correct"));
  }
  SECTION("too many poses") {
    data.write("poses.txt", data.read("poses.txt") + "1 0 0 0 0 1 0 0 0 0 1 0\n");
    CHECK(failure(data) ==
          "DATA/poses.txt: has 5 entries, but there are 4 images; one line per image is needed");
  }
  SECTION("poses named and not there") {
    CHECK(failure(data, {{"poses", data.path("t.txt").string()}}) ==
          "DATA/t.txt: is missing; restore it, or correct the path");
  }
  SECTION("a selection beyond the end is the configuration's fault") {
    KittiSource source;
    test::TestContext services({{"path", data.path().string()}, {"first", std::int64_t{4}}});
    const Context context = services;
    const Status status = source.configure(context);
    CHECK(status.code() == StatusCode::InvalidParameter);
    CHECK(status.message() == "first is 4, but the data end at frame 3; choose a smaller one");
    CHECK(inspect(source).front() == "error configuration: " + status.message());
  }
}

TEST_CASE("damaged images stop the run at their frame, or give a frame without images") {
  const DataFolder data;
  std::string expected;
  SECTION("truncated PNG") {
    data.truncate("image_1/000001.png", 0.5);
    expected = "DATA/image_1/000001.png: is a truncated PNG file" + kRemedy;
  }
  SECTION("no image") {
    data.write("image_0/000001.png", "garbage");
    expected = "DATA/image_0/000001.png: is neither a PNG nor a JPEG file" + kRemedy;
  }
  SECTION("another size, right") {
    data.writeImage("image_1/000001.png", 32, 48);
    expected = "DATA/image_1/000001.png: has 32x48 pixels, but the first image has 64x48" + kRemedy;
  }
  SECTION("truncated JPEG") {
    data.remove("image_0/000001.png");
    data.writeImage("image_0/000001.jpg", 64, 48);
    data.truncate("image_0/000001.jpg", 0.7);
    expected =
        "DATA/image_0/000001.jpg: is a truncated JPEG file: its end marker is missing" + kRemedy;
  }
  CHECK(failure(data) == expected);

  KittiSource skipping;
  REQUIRE(configure(skipping, {{"path", data.path().string()}, {"on_corrupt", std::string("skip")}})
              .empty());
  std::string message;
  const std::vector<Frame> frames = readAll(skipping, message);
  CHECK(message.empty());
  REQUIRE(frames.size() == 4);
  CHECK(frames[1].left.empty());
  CHECK(frames[1].right.empty());
  // Without the advice that was taken.
  CHECK(data.anonymous(frames[1].defect) + kRemedy == expected);
  CHECK(frames[1].stamp_ns == 100'000'000);
  CHECK(frames[2].defect.empty());
  CHECK_FALSE(frames[2].left.empty());
}

TEST_CASE("after a frame that failed the next one comes") {
  const DataFolder data;
  data.write("image_0/000000.png", "");
  KittiSource source;
  REQUIRE(configure(source, {{"path", data.path().string()}}).empty());
  Frame frame;
  CHECK(source.next(frame).code() == StatusCode::InvalidInput);
  REQUIRE(source.next(frame).isOk());
  CHECK(frame.frame == 1);
}

TEST_CASE("inspect tells every problem, though configure failed at the first") {
  const DataFolder data;
  data.remove("image_1/000003.png");
  data.truncate("image_0/000002.png", 0.5);
  data.writeImage("image_1/000000.png", 32, 32);
  data.write("calib.txt", matrixLine("P0", 0) + matrixLine("P1", 0));
  data.write("times.txt", "0.0\nx\n0.1\n0.05\n0.2\n");
  data.write("poses.txt", "1 0 0 inf 0 1 0 0 0 0 1 0\n");
  const std::vector<std::string> all = findings(data);
  const std::vector<std::string> beginnings = {
      "error DATA/image_1: has no 000003, the partner",
      "error DATA/calib.txt:2: baseline is 0.0000 m: both",
      "error DATA/times.txt:2: 'x' is no time",
      "error DATA/times.txt:4: time goes back by 0.050000 s",
      "error DATA/times.txt: has 5 entries, but there are 4",
      "error DATA/poses.txt:1: 'inf' is no finite number",
      "error DATA/poses.txt: has 1 entries, but there are 4",
      "error DATA/image_0/000002.png: is a truncated PNG file",
      "error DATA/image_1/000000.png: has 32x32 pixels, but the first image has 64x48",
      "note DATA/image_0: KITTI odometry, 4"};
  REQUIRE(all.size() == beginnings.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    CAPTURE(all[i]);
    CHECK(all[i].starts_with(beginnings[i]));
  }
}

TEST_CASE("inspect of a source that was never configured, or of nothing, says so") {
  const DataFolder data;
  KittiSource source;
  CHECK(inspect(source).front() == "error configuration: configure() was not called");
  data.remove("image_0");
  CHECK(findings(data).front().starts_with("error DATA/: has neither image_0 nor image_2"));
}

TEST_CASE("garbage in any text file is an error, never a crash") {
  RandomStream random(5);
  for (const std::string name : {"calib.txt", "times.txt", "poses.txt"}) {
    const DataFolder data;
    const std::string sound = data.read(name);
    for (int i = 0; i < 60; ++i) {
      std::string text = sound;
      const std::uint64_t changes = 1 + random.below(20);
      for (std::uint64_t c = 0; c < changes; ++c) {
        text[random.below(text.size())] = static_cast<char>(random.below(256));
      }
      data.write(name, text);
      KittiSource source;
      const std::string message = configure(source, {{"path", data.path().string()}});
      SourceInfo info;
      if (message.empty()) CHECK(source.info(info).isOk());
      CHECK_FALSE(inspect(source).empty());
    }
    data.write(name, std::string(3000, '\xff'));
    CHECK(failure(data).find(name) != std::string::npos);
  }
}

}  // namespace tolman::image_folders
