// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/trajectory_files.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>

#include "support/data.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

class Folder {
 public:
  std::filesystem::path file(const std::string& text) const {
    const auto path = folder_.path() / "poses.txt";
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  /// The message without the folder's name.
  std::string refusal(const Result<Trajectory>& result) const {
    REQUIRE_FALSE(result.isOk());
    CHECK(result.status().code() == StatusCode::InvalidInput);
    const std::string prefix = folder_.path().string() + "/";
    const std::string message = result.status().message();
    REQUIRE(message.substr(0, prefix.size()) == prefix);
    return message.substr(prefix.size());
  }
  std::string tumRefusal(const std::string& text) const {
    return refusal(readTrajectory(file(text)));
  }
  std::string kittiRefusal(const std::string& text) const {
    return refusal(readTrajectory(file(text)));
  }

 private:
  test::TemporaryFolder folder_;
};

const std::string kIdentity = "1 0 0 0 0 1 0 0 0 0 1 0\n";

}  // namespace

TEST_CASE("a TUM file is read: comments, blank lines, stamps exact to the nanosecond") {
  const Folder folder;
  const auto path = folder.file(
      "# stamp tx ty tz qx qy qz qw\n"
      "1403636579.763555527 1 2 3 0 0 0 1\r\n"
      "\n"
      "1403636579.863555528 1 2 4 0 0.7071067811865476 0 0.7071067811865476 # turned\n"
      "1.403636580e+09 0 0 0 0 0 0 -1\n");
  const auto trajectory = readTrajectory(path).value();
  REQUIRE(trajectory.size() == 3);
  // As a double these stamps are 238 ns apart from their neighbours.
  CHECK(trajectory[0].stamp_ns == 1403636579763555527);
  CHECK(trajectory[1].stamp_ns == 1403636579863555528);
  CHECK(trajectory[2].stamp_ns == 1403636580000000000);
  CHECK(trajectory[1].frame == 1);
  CHECK(trajectory[0].T_world_camera.translation() == Eigen::Vector3d(1, 2, 3));
  // A quarter turn about y takes the optical axis to +x.
  const Eigen::Vector3d axis = trajectory[1].T_world_camera.linear().col(2);
  CHECK((axis - Eigen::Vector3d::UnitX()).norm() < 1e-12);
}

TEST_CASE("a KITTI file is read row by row") {
  const Folder folder;
  const auto trajectory =
      readTrajectory(folder.file(kIdentity + "0 0 1 7 0 1 0 8 -1 0 0 9\n")).value();
  REQUIRE(trajectory.size() == 2);
  CHECK(trajectory[1].T_world_camera.translation() == Eigen::Vector3d(7, 8, 9));
  CHECK((trajectory[1].T_world_camera.linear().col(2) - Eigen::Vector3d::UnitX()).norm() < 1e-12);
}

TEST_CASE("the format is found out from the first pose") {
  const Folder folder;
  CHECK(readTrajectory(folder.file("# c\n1 0 0 0 0 0 0 1\n")).value().size() == 1);
  CHECK(readTrajectory(folder.file(kIdentity)).value().size() == 1);
  CHECK(folder.refusal(readTrajectory(folder.file("1 2 3\n"))) ==
        "poses.txt:1: neither a TUM pose (8 numbers) nor a KITTI pose (12 numbers): found 3 "
        "entries");
}

TEST_CASE("a CSV file of EuRoC is named as such") {
  const Folder folder;
  const std::string message =
      "poses.txt:2: is of a CSV file of EuRoC or TUM-VI (stamps in ns, qw before qx); give a TUM "
      "file, as 'evo_traj euroc FILE --save_as_tum' writes it";
  const std::string header = "#timestamp [ns], p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m]\n";
  const std::string pose = "1403636580838555648,4.688,-1.786,0.783,0.534,-0.153,-0.827,-0.082";
  CHECK(folder.tumRefusal(header + pose + "\n") == message);
  CHECK(folder.tumRefusal(header + pose + ",-0.027,0.033,0.8,0,0,0,0,0,0\n") == message);
  // TUM files with commas are read as before.
  CHECK(readTrajectory(folder.file("1403636580.838,0,0,0,0,0,0,1\n")).isOk());
}

TEST_CASE("broken trajectory files are refused with file and line") {
  const Folder folder;
  CHECK(folder.tumRefusal("") == "poses.txt: holds no pose");
  CHECK(folder.tumRefusal("# nothing\n\n") == "poses.txt: holds no pose");
  CHECK(folder.tumRefusal("1 0 0 0 0 0 0 1\n2 0 0 0 0 0 1\n") ==
        "poses.txt:2: expected 8 numbers (stamp tx ty tz qx qy qz qw), found 7");
  CHECK(folder.tumRefusal("1 0 nan 0 0 0 0 1\n") == "poses.txt:1: 'nan' is no finite number");
  CHECK(folder.tumRefusal("1 0 1e999 0 0 0 0 1\n") ==
        "poses.txt:1: '1e999' is too large for a double");
  CHECK(folder.tumRefusal("1 0 1e-400 0 0 0 0 1\n") ==
        "poses.txt:1: '1e-400' is too small for a double (write 0)");
  CHECK(folder.tumRefusal("1 0 1e300 0 0 0 0 1\n") ==
        "poses.txt:1: position '1e300' is too large; positions are metres");
  CHECK(folder.kittiRefusal("1 0 0 0 0 1 0 -1e300 0 0 1 0\n") ==
        "poses.txt:1: position '-1e300' is too large; positions are metres");
  CHECK(folder.tumRefusal("1 0 12x 0 0 0 0 1\n") == "poses.txt:1: '12x' is no finite number");
  CHECK(folder.tumRefusal("2 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n") ==
        "poses.txt:2: the stamp does not increase; sort the file and remove duplicates");
  CHECK(folder.tumRefusal("1 0 0 0 0 0 0 0.5\n") ==
        "poses.txt:1: the quaternion has length 0.500000 instead of 1");
  CHECK(folder.tumRefusal("99999999999 0 0 0 0 0 0 1\n") ==
        "poses.txt:1: stamp '99999999999' is too large; stamps are seconds: divide ns by 1e9, us "
        "by 1e6 and ms by 1e3");
  CHECK(folder.tumRefusal("-4000000001 0 0 0 0 0 0 1\n") ==
        "poses.txt:1: stamp '-4000000001' is too large; stamps are seconds: divide ns by 1e9, us "
        "by 1e6 and ms by 1e3");
  CHECK(folder.kittiRefusal(kIdentity + "1 2 3\n") ==
        "poses.txt:2: expected 12 numbers (rows of a 3x4 pose), found 3");
  CHECK(folder.kittiRefusal("1 0 0 0 0 1 0 0 0 0 -1 0\n") ==
        "poses.txt:1: the rotation part is not a rotation matrix");  // a reflection
  CHECK(folder.kittiRefusal("2 0 0 0 0 2 0 0 0 0 2 0\n") ==
        "poses.txt:1: the rotation part is not a rotation matrix");
  CHECK(readTrajectory("/nowhere/at/all").status().message() ==
        "/nowhere/at/all: cannot be read (No such file or directory); check path and permissions");
  CHECK_FALSE(readTrajectory("/tmp").isOk());
}

TEST_CASE("a file cut within its last number is refused, one without a last line end is not") {
  const Folder folder;
  const std::string rotation = "1 0 0 0.5 0 1 0 0 0 0 1 ";
  const std::string two = rotation + "-1.250000e+00\n" + rotation + "2.500000e+01\n";
  CHECK(readTrajectory(folder.file(two + rotation + "-1.750000e+01")).value().size() == 3);
  CHECK(folder.kittiRefusal(two + rotation + "-1.750000e+0") ==
        "poses.txt:3: the file ends within this line, its last number '-1.750000e+0' is cut; put "
        "back the whole file");
  // A line that has an end is as it was meant.
  CHECK(readTrajectory(folder.file(two + rotation + "-1.750000e+0\n")).isOk());
  const std::string tum = "0 1 2 3 0 0 0 1.00\n1 1 2 3 0 0 0 1.00\n2 1 2 3 0 0 0 1";
  CHECK(readTrajectory(folder.file(tum + ".00")).value().size() == 3);
  for (const char* end : {".0", ".", ""}) {
    CHECK_THAT(folder.tumRefusal(tum + end), Catch::Contains("is cut; put back the whole file"));
  }
  CHECK(readTrajectory(folder.file("0 1 2 3 0 0 0 1\n1 1 2 3 0 0 0 1")).isOk());
}

TEST_CASE("random bytes never crash a reader, and its message is printable") {
  const Folder folder;
  RandomStream random(7);
  for (int round = 0; round < 200; ++round) {
    std::string junk = round % 2 == 0 ? "1 0 0 0 0 0 0 1\n" : kIdentity;  // decides on the format
    const auto size = random.below(400);
    for (std::uint64_t i = 0; i < size; ++i) {
      // Half of all bytes are those of numbers, so that the junk gets past the first word.
      junk += random.uniform() < 0.5 ? "0123456789 .-e\n"[random.below(15)]
                                     : static_cast<char>(random.below(256));
    }
    const auto result = readTrajectory(folder.file(junk));
    if (result.isOk()) continue;
    const std::string message = result.status().message();
    CHECK(std::all_of(message.begin(), message.end(), [](char c) { return c >= ' ' && c <= '~'; }));
  }
}
