// SPDX-License-Identifier: BSD-3-Clause
// Which images show the same place: by number, by a file of pairs, by poses.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <numbers>
#include <string>

#include "experiment/bench.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::experiment;
using tolman::test::TemporaryFolder;

namespace {

struct PairsFile {
  TemporaryFolder folder;
  std::filesystem::path path = folder.path() / "pairs.csv";

  Result<PlaceTruth> read(const std::string& text) const {
    std::ofstream(path, std::ios::binary) << text;
    return truthOfPairs(path);
  }
  /// The message, without the folder.
  std::string refusalOf(const std::string& text) const {
    const auto truth = read(text);
    REQUIRE_FALSE(truth.isOk());
    CHECK(truth.status().code() == StatusCode::InvalidInput);
    const std::string message = truth.status().message();
    const std::string begin = folder.path().string() + "/";
    REQUIRE(message.starts_with(begin));
    return message.substr(begin.size());
  }
};

/// A pose at (x, z), heading to the left by `degrees`.
evaluation::TrajectoryPose poseAt(std::int64_t frame, double x, double z, double degrees) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << x, 0, z;
  T.linear() = Eigen::AngleAxisd(-degrees * std::numbers::pi / 180, Eigen::Vector3d::UnitY())
                   .toRotationMatrix();
  return {frame, frame, T};
}

}  // namespace

TEST_CASE("a header of another order and matches that are not earlier are refused") {
  const PairsFile file;
  CHECK(file.refusalOf("match,query\n2,30\n") ==
        "pairs.csv:1: a pair is two numbers of images, 'query,match'");
  for (const char* match : {"30", "31"}) {
    CHECK(file.refusalOf(std::string("query,match\n30,2\n30,") + match + "\n") ==
          "pairs.csv:3: the match must be an earlier image than the query");
  }
}

TEST_CASE("two passes: image N of both shows the same place, and so do its neighbours") {
  const PlaceTruth truth = truthByNumber(100, 5);
  CHECK(truth.isSame(50, 50));
  CHECK(truth.isSame(50, 45));
  CHECK(truth.isSame(50, 55));
  CHECK_FALSE(truth.isSame(50, 44));
  CHECK_FALSE(truth.isSame(50, 56));
  CHECK(truth.isFindable(0));
  CHECK(truth.isFindable(104));  // image 99 is five away
  CHECK_FALSE(truth.isFindable(105));
  const PlaceTruth exact = truthByNumber(100, 0);
  CHECK(exact.isSame(7, 7));
  CHECK_FALSE(exact.isSame(7, 8));
  CHECK_FALSE(exact.isFindable(100));
}

TEST_CASE("pairs are those of the file, in the order query, match") {
  const PairsFile file;
  for (const char* text : {"query,match\n30,2\n30,3\n41,10\n",
                           "query,match\r\n30,2\r\n30,3\r\n41,10", "30,2\n30,3\n41,10\n"}) {
    const auto truth = file.read(text);
    CAPTURE(text);
    REQUIRE(truth.isOk());
    CHECK(truth.value().isSame(30, 2));
    CHECK(truth.value().isSame(30, 3));
    CHECK(truth.value().isSame(41, 10));
    CHECK_FALSE(truth.value().isSame(2, 30));
    CHECK_FALSE(truth.value().isSame(30, 4));
    CHECK(truth.value().isFindable(30));
    CHECK(truth.value().isFindable(41));
    CHECK_FALSE(truth.value().isFindable(2));
    CHECK_FALSE(truth.value().isFindable(31));
    CHECK_FALSE(truth.value().isFindable(42));
  }
}

TEST_CASE("pairs of images that are near make no query findable") {
  const PairsFile file;
  std::ofstream(file.path) << "30,2\n30,29\n41,40\n41,39\n";
  const PlaceTruth truth = truthOfPairs(file.path, 20).value();
  CHECK(truth.isFindable(30));
  CHECK_FALSE(truth.isFindable(41));
  CHECK(truth.isSame(41, 40));
  CHECK_FALSE(truthOfPairs(file.path, 28).value().isFindable(30));
}

TEST_CASE("a line that is no pair is refused with file and line") {
  const PairsFile file;
  const std::string wanted = ": a pair is two numbers of images, 'query,match'";
  CHECK(file.refusalOf("query,match\n2,1\n3;4\n") == "pairs.csv:3" + wanted);
  CHECK(file.refusalOf("query,match\n1\n") == "pairs.csv:2" + wanted);
  CHECK(file.refusalOf("query,match\n1,\n") == "pairs.csv:2" + wanted);
  CHECK(file.refusalOf("query,match\n1,2,3\n") == "pairs.csv:2" + wanted);
  CHECK(file.refusalOf("query,match\n1,2.5\n") == "pairs.csv:2" + wanted);
  CHECK(file.refusalOf("query,match\n5,-1\n") == "pairs.csv:2" + wanted);
  CHECK(file.refusalOf("query,match\n5,3\n\n6,4\n") == "pairs.csv:3" + wanted);
  CHECK(file.refusalOf("query,match\n99999999999999999999,1\n") == "pairs.csv:2" + wanted);
  CHECK(file.refusalOf("2,1\nnot,numbers\n") == "pairs.csv:2" + wanted);
}

TEST_CASE("a file without pairs is refused, not scored as if nothing could be found") {
  const PairsFile file;
  const std::string wanted = "pairs.csv: lists no pairs; each line is 'query,match'";
  CHECK(file.refusalOf("") == wanted);
  CHECK(file.refusalOf("query,match\n") == wanted);
  CHECK(file.refusalOf("something else") ==
        "pairs.csv:1: a pair is two numbers of images, 'query,match'");
}

TEST_CASE("what is no file is refused at once, also a pipe that nobody writes to") {
  const TemporaryFolder folder;
  const auto refusal = [](const std::filesystem::path& path) {
    return truthOfPairs(path).status().message();
  };
  const std::string absent = folder.path() / "absent.csv";
  CHECK(refusal(absent) == absent + ": is missing; restore it, or correct the path");
  const std::string pipe = folder.path() / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  for (const std::string& path : {folder.path().string(), pipe}) {
    CHECK(refusal(path) == path + ": is no text file; correct the path");
  }
}

TEST_CASE("poses: within 5 m and 45 degrees, and findable only after more than 20 m of path") {
  evaluation::Trajectory path;
  for (int i = 0; i <= 30; ++i) path.push_back(poseAt(i, 0, i, 0));  // 30 m ahead
  path.push_back(poseAt(31, 40, 30, 0));
  path.push_back(poseAt(32, 3, 2, 30));   // back at frame 2, turned a little
  path.push_back(poseAt(33, 3, 2, 90));   // turned too far
  path.push_back(poseAt(34, 3, 2, 180));  // the other way
  path.push_back(poseAt(35, -6, 10, 0));  // beside the path
  const PlaceTruth truth = truthOfPoses(path);
  CHECK(truth.isSame(32, 2));
  CHECK(truth.isSame(32, 5));  // 4.2 m
  CHECK_FALSE(truth.isSame(32, 7));
  CHECK_FALSE(truth.isSame(33, 2));
  CHECK_FALSE(truth.isSame(34, 2));
  CHECK_FALSE(truth.isSame(35, 10));
  CHECK(truth.isFindable(32));
  CHECK_FALSE(truth.isFindable(33));
  CHECK_FALSE(truth.isFindable(34));
  CHECK_FALSE(truth.isFindable(35));
  CHECK(truthOfPoses(path, 0, 29).isFindable(32));  // at frame 2
  CHECK_FALSE(truthOfPoses(path, 0, 32).isFindable(32));
  for (int i = 0; i <= 31; ++i) CHECK_FALSE(truth.isFindable(i));  // the neighbours are too recent
  CHECK_FALSE(truthOfPoses({}).isFindable(0));
}

TEST_CASE("poses of another storey are another place where a height is given") {
  evaluation::Trajectory path;
  for (int i = 0; i <= 30; ++i) path.push_back(poseAt(i, 0, i, 0));
  path.push_back(poseAt(31, 40, 30, 0));
  path.push_back(poseAt(32, 0, 2, 0));
  path.back().T_world_camera.translation().y() = -3;  // 3 m above frame 2
  CHECK(truthOfPoses(path).isSame(32, 2));
  CHECK(truthOfPoses(path).isFindable(32));
  CHECK_FALSE(truthOfPoses(path, 1.5).isSame(32, 2));
  CHECK_FALSE(truthOfPoses(path, 1.5).isFindable(32));
  CHECK(truthOfPoses(path, 3.5).isSame(32, 2));
}
