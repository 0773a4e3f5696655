// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>

#include "evaluation/trajectory.hpp"
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
        "poses.txt:1: neither a TUM pose (8 numbers) nor a KITTI pose (12 numbers), nor stamp x y "
        "z (4), nor a frame with its pose (13 or 17): found 3 entries; other tables need a first "
        "line with the names of their columns");
}

TEST_CASE("tables of EuRoC and TUM-VI: ns, w first, with and without velocities") {
  const Folder folder;
  const std::string names =
      "#timestamp [ns], p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], "
      "q_RS_z []";
  const std::string pose = "1403636580838555648,4.5,-1.75,0.5,0.5,0.5,-0.5,0.5";
  const std::string more =
      ", v_RS_R_x [m s^-1], v_RS_R_y [m s^-1], v_RS_R_z [m s^-1], b_w_RS_S_x "
      "[rad s^-1], b_w_RS_S_y [rad s^-1], b_w_RS_S_z [rad s^-1], b_a_RS_S_x "
      "[m s^-2], b_a_RS_S_y [m s^-2], b_a_RS_S_z [m s^-2]";
  const std::string all = names + more + "\n" + pose + ",-0.027,0.033,0.8,0,0,0,0,0,0\n";
  for (const std::string& text : {names + "\n" + pose + "\n", all, pose + "\n"}) {
    const auto path = readTrajectory(folder.file(text)).value();
    REQUIRE(path.size() == 1);
    CHECK(path[0].stamp_ns == 1403636580838555648);
    CHECK(path[0].T_world_camera.translation() == Eigen::Vector3d(4.5, -1.75, 0.5));
    const Eigen::Quaterniond q(path[0].T_world_camera.linear());
    CHECK(q.isApprox(Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5), 1e-12));
  }
  const auto leica = readTrajectory(folder.file(
      "#timestamp [ns], p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m]\n1403636580838555648,1,2,3\n"));
  CHECK(leica.value()[0].T_world_camera.translation() == Eigen::Vector3d(1, 2, 3));
  CHECK_FALSE(hasOrientations(leica.value()));
  // TUM files with commas are read as before.
  CHECK(readTrajectory(folder.file("1403636580.838,0,0,0,0,0,0,1\n")).isOk());
}

TEST_CASE("tables are read by the names of their columns, positions alone too") {
  const Folder folder;
  const auto named = readTrajectory(folder.file(
      "seq,field.header.stamp_ns,field.header.frame_id,pose.position.x,pose.position.y,"
      "pose.position.z,pose.orientation.x,pose.orientation.y,pose.orientation.z,"
      "pose.orientation.w,twist.linear.x\n"
      "7,1403636580838555648,map,1,2,3,0,0,0,1,9\n8,1403636580938555648,map,1,2,4,0,0,0,1,9\n"));
  REQUIRE(named.isOk());
  CHECK(named.value()[1].stamp_ns == 1403636580938555648);
  CHECK(named.value()[1].T_world_camera.translation() == Eigen::Vector3d(1, 2, 4));
  const auto positions =
      readTrajectory(folder.file("x;y;z;time [ms]\n1;2;3;1500.5\n1;2;4;1600.5\n")).value();
  CHECK(positions[0].stamp_ns == 1'500'500'000);
  CHECK(positions[1].T_world_camera.translation().z() == 4);
  // A comment that names other columns than there are is no header.
  CHECK(readTrajectory(folder.file("# x y z\n1 0 0 0 0 0 0 1\n")).value()[0].stamp_ns ==
        1'000'000'000);
}

TEST_CASE("poses with frame numbers, as KITTI-360 has them") {
  const Folder folder;
  const auto framed = readTrajectory(folder.file("4 1 0 0 7 0 1 0 8 0 0 1 9\n9 " + kIdentity));
  REQUIRE(framed.isOk());
  CHECK(framed.value()[0].frame == 4);
  CHECK(framed.value()[1].frame == 9);
  CHECK(framed.value()[0].T_world_camera.translation() == Eigen::Vector3d(7, 8, 9));
  const auto square = readTrajectory(folder.file("3 1 0 0 7 0 1 0 8 0 0 1 9 0 0 0 1\n")).value();
  CHECK(square[0].frame == 3);
  CHECK_FALSE(hasStamps(square));
  CHECK(folder.refusal(readTrajectory(folder.file("4 " + kIdentity + "4 " + kIdentity))) ==
        "poses.txt:2: the frame does not increase; sort the file and remove duplicates");
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
        "/nowhere/at/all: is missing; restore it, or correct the path");
  CHECK_FALSE(readTrajectory("/tmp").isOk());
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
