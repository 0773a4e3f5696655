// SPDX-License-Identifier: BSD-3-Clause
// Pose files: valid ones, messages for invalid ones, and real ones.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "drawn_route.hpp"
#include "support/data.hpp"

namespace tolman::town::test {
namespace {

using tolman::test::dataOrSkip;
using tolman::test::TemporaryFolder;

const std::string kStart = "1 0 0 0 0 1 0 0 0 0 1 0\n";
const std::string kOneAhead = "1 0 0 0 0 1 0 0 0 0 1 1\n";

class PoseFile {
 public:
  explicit PoseFile(const std::string& text) : path_(folder_.path() / "drive.txt") {
    std::ofstream(path_) << text;
  }
  Result<CameraRoute> read(double rate = 10) const {
    RouteOptions options;
    options.rate = rate;
    return readRoute(path_, options);
  }
  /// The message without the folder.
  std::string refusal(double rate = 10) const {
    const Result<CameraRoute> route = read(rate);
    if (route.isOk()) return "read";
    CHECK(route.status().code() == StatusCode::InvalidInput);
    const std::string message = route.status().message();
    const std::string folder = folder_.path().string() + "/";
    return message.starts_with(folder) ? message.substr(folder.size()) : message;
  }

 private:
  TemporaryFolder folder_;
  std::filesystem::path path_;
};

std::string kittiLine(const Eigen::Isometry3d& T) {
  std::ostringstream line;
  line << std::setprecision(17);
  for (int i = 0; i < 12; ++i) line << (i > 0 ? " " : "") << T.matrix()(i / 4, i % 4);
  return line.str() + "\n";
}

}  // namespace

TEST_CASE("the first pose of a file is the origin of the town, camera forward is Y, down is -Z") {
  const PoseFile file(kStart + "1 0 0 0.2 0 1 0 -0.1 0 0 1 1.5\n");
  const CameraRoute route = file.read().value();
  CHECK(route.name == "drive");
  REQUIRE(route.T_town_camera.size() == 2);
  CHECK(route.T_town_camera[0].translation().norm() < 1e-12);
  CHECK((route.T_town_camera[0] * Eigen::Vector3d(1, 2, 3) - Eigen::Vector3d(1, 3, -2)).norm() <
        1e-12);
  CHECK((route.T_town_camera[1].translation() - Eigen::Vector3d(0.2, 1.5, 0.1)).norm() < 1e-12);
}

TEST_CASE("stamps follow the rate to the nanosecond") {
  const CameraRoute route = PoseFile(kStart + kOneAhead + kOneAhead + kOneAhead).read(30).value();
  CHECK(route.stamps_ns == std::vector<std::int64_t>{0, 33333333, 66666667, 100000000});
}

TEST_CASE("a built-in route comes back from its file, whatever frame that was written in") {
  const CameraRoute block = builtIn("block");
  Eigen::Isometry3d T_world_town = Eigen::Isometry3d::Identity();
  T_world_town.rotate(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()));
  T_world_town.pretranslate(Eigen::Vector3d(400, -30, 7));
  std::string text;
  for (const Eigen::Isometry3d& T : block.T_town_camera) text += kittiLine(T_world_town * T);
  const CameraRoute read = PoseFile(text).read().value();
  REQUIRE(read.T_town_camera.size() == block.T_town_camera.size());
  CHECK(read.stamps_ns == block.stamps_ns);
  for (std::size_t i = 0; i < read.T_town_camera.size(); ++i) {
    REQUIRE(read.T_town_camera[i].isApprox(block.T_town_camera[i], 1e-9));
  }
}

TEST_CASE("rotations that print few digits are made orthogonal") {
  const PoseFile file(kStart + "0.9998 0.0199 0 0 -0.0199 0.9998 0 0 0 0 1 1\n");
  const Eigen::Matrix3d R = file.read().value().T_town_camera[1].linear();
  CHECK((R.transpose() * R - Eigen::Matrix3d::Identity()).norm() < 1e-12);
}

TEST_CASE("blank lines, Windows line ends, tabs and plus signs do not matter") {
  const PoseFile file("1 0 0 0\t0 1 0 0 0 0 +1 0\r\n\n  \n1 0 0 0 0 1 0 0 0 0 1 1e0");
  CHECK(file.read().value().T_town_camera.size() == 2);
}

TEST_CASE("files without a drive are refused") {
  RouteOptions options;
  CHECK(readRoute("/nowhere/drive.txt", options).status().message() ==
        "/nowhere/drive.txt: there is no such file; correct the path, or use block, eights, "
        "district, highway or car_park");
  CHECK(PoseFile("").refusal() == "drive.txt: has no pose; a drive needs two or more");
  CHECK(PoseFile("\n\n").refusal() == "drive.txt: has no pose; a drive needs two or more");
  CHECK(PoseFile(kStart).refusal() == "drive.txt: has one pose; a drive needs two or more");
  const TemporaryFolder folder;
  for (const std::string& other : {folder.path().string(), std::string("/dev/null")}) {
    CHECK(readRoute(other, options).status().message() ==
          other + ": is a folder or device; give a KITTI pose file");
  }
}

TEST_CASE("lines that are no pose are refused with their number") {
  CHECK(PoseFile(kStart + "1 0 0 0 0 1 0 0 0 0 1\n").refusal() ==
        "drive.txt:2: has 11 numbers; a pose has 12, row by row");
  CHECK(PoseFile(kStart + "\n0 1 0 0 0 0 1 0 0 0 0 1 0\n").refusal() ==
        "drive.txt:3: has 13 numbers; a pose has 12, row by row");
  CHECK(PoseFile("1 0 0 nan 0 1 0 0 0 0 1 0\n").refusal() ==
        "drive.txt:1: 'nan' is no finite number; correct the pose");
  CHECK(PoseFile("1 0 0 -inf 0 1 0 0 0 0 1 0\n").refusal() ==
        "drive.txt:1: '-inf' is no finite number; correct the pose");
  CHECK(PoseFile("1 0 0 1e999 0 1 0 0 0 0 1 0\n").refusal() ==
        "drive.txt:1: '1e999' is too large for a double; correct the pose");
  CHECK(PoseFile("1 0 0 3.5m 0 1 0 0 0 0 1 0\n").refusal() ==
        "drive.txt:1: '3.5m' is no finite number; correct the pose");
}

TEST_CASE("matrices that are no rotation are refused") {
  const std::string message =
      "drive.txt:2: its first three columns are no rotation; write camera-to-world poses";
  CHECK(PoseFile(kStart + "2 0 0 0 0 2 0 0 0 0 2 0\n").refusal() == message);
  CHECK(PoseFile(kStart + "-1 0 0 0 0 1 0 0 0 0 1 0\n").refusal() == message);  // a mirror
  CHECK(PoseFile(kStart + "0 0 0 0 0 0 0 0 0 0 0 0\n").refusal() == message);
  CHECK(PoseFile(kStart + "1 0.01 0 0 0 1 0 0 0 0 1 0\n").refusal() == message);
}

TEST_CASE("jumps that no car drives are refused") {
  const std::string far = "1 0 0 0 0 1 0 0 0 0 1 12.5\n";
  CHECK(PoseFile(kStart + far).refusal() ==
        "drive.txt:2: is 12.5 m from the pose before, farther than a car drives in 0.100 s "
        "(6.0 m); remove the jump, or correct the frame rate");
  CHECK(PoseFile(kStart + far).refusal(2) == "read");  // 25 m/s
  CHECK(PoseFile(kStart + "1 0 0 0 0 1 0 0 0 0 1 4.9\n").refusal(100) == "read");
  CHECK(PoseFile(kStart + "0 0 1 0 0 1 0 0 -1 0 0 1\n").refusal() ==
        "drive.txt:2: is turned by 90 degrees from the pose before, more than 60; remove the jump, "
        "or correct the frame rate");
  CHECK(
      PoseFile(kStart + "1 0 0 1e300 0 1 0 0 0 0 1 0\n").refusal().starts_with("drive.txt:2: is "));
}

TEST_CASE("a rate that is none is the configuration's fault") {
  const Result<CameraRoute> route = PoseFile(kStart + kOneAhead).read(0);
  CHECK(route.status().code() == StatusCode::InvalidParameter);
  CHECK(route.status().message() == "rate must be positive; give frames/s");
}

TEST_CASE("KITTI's drives are read whole", "[data]") {
  struct Drive {
    const char* file;
    std::size_t frames;
    double length;  // m, as published: 3724, 2206, 1233, 695
  };
  for (const Drive& drive : {Drive{"00.txt", 4541, 3724}, Drive{"05.txt", 2761, 2206},
                             Drive{"06.txt", 1101, 1233}, Drive{"07.txt", 1101, 695}}) {
    const auto file = dataOrSkip(std::string("kitti_poses/") + drive.file);
    if (!file) return;
    const CameraRoute route = readRoute(*file, {}).value();
    CHECK(route.T_town_camera.size() == drive.frames);
    double length = 0;
    for (std::size_t i = 1; i < drive.frames; ++i) {
      const Eigen::Vector3d step =
          route.T_town_camera[i].translation() - route.T_town_camera[i - 1].translation();
      length += step.norm();
    }
    CHECK(length == Approx(drive.length).margin(1));
    // The car drives forward on level ground: Z is up.
    CHECK(route.T_town_camera[5].translation().y() > 0.3);
    CHECK(std::abs(route.T_town_camera[5].translation().z()) < 0.5);
  }
}

}  // namespace tolman::town::test
