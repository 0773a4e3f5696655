// SPDX-License-Identifier: BSD-3-Clause
// Pose graphs: the round trip, chains against products of matrices, drives as they are published
// (chain and loops in one file, spatial, with vertices), and invalid files.
#include "g2o_edges.hpp"

#include <sys/stat.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "support/data.hpp"
#include "tolman/context.hpp"

namespace tolman::motion_log {
namespace {

struct EdgeFile {
  explicit EdgeFile(const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

  std::string refusal() const {
    const auto edges = readGraph(path);
    REQUIRE_FALSE(edges.isOk());
    REQUIRE(edges.status().code() == StatusCode::InvalidInput);
    std::string message = edges.status().message();
    REQUIRE(message.starts_with(path.string()));
    return message.substr(path.string().size());
  }

  test::TemporaryFolder folder;
  std::filesystem::path path = folder.path() / "edges.g2o";
};

std::string edgeText(const Edge& edge, const char* end = " 1 0 0 1 0 1\n") {
  std::ostringstream text;
  text << std::setprecision(17) << "EDGE_SE2 " << edge.from << ' ' << edge.to << ' '
       << edge.motion.x << ' ' << edge.motion.y << ' ' << edge.motion.theta << end;
  return text.str();
}

std::vector<Edge> randomChain(std::uint64_t seed, int count) {
  RandomStream random(seed);
  std::vector<Edge> edges;
  for (int i = 0; i < count; ++i) {
    edges.push_back(
        {i, i + 1, {random.uniform(-2, 2), random.normal(), random.uniform(-3.1, 3.1)}, i + 1});
  }
  return edges;
}

}  // namespace

TEST_CASE("edges come back to the last bit, with Windows line ends and any blanks too") {
  for (const char* end : {" 1 0 0 1 0 1\n", " 4 -1 0.5 3 0 1e6\r\n", "\t1 0 0 1 0 1   \n\n",
                          " 1 0 0 1 0 1\n# a comment\n\r\n"}) {
    const std::vector<Edge> written = randomChain(3, 50);
    std::string text;
    for (const Edge& edge : written) text += edgeText(edge, end);
    const EdgeFile file(text);
    const auto read = readGraph(file.path);
    CAPTURE(end, read.status().message());
    REQUIRE(read.isOk());
    REQUIRE(read.value().edges.size() == written.size());
    for (std::size_t i = 0; i < written.size(); ++i) {
      REQUIRE(read.value().edges[i].from == written[i].from);
      REQUIRE(read.value().edges[i].to == written[i].to);
      REQUIRE(read.value().edges[i].motion.x == written[i].motion.x);
      REQUIRE(read.value().edges[i].motion.y == written[i].motion.y);
      REQUIRE(read.value().edges[i].motion.theta == written[i].motion.theta);
    }
  }
}

TEST_CASE("a chain is the product of its steps' matrices") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const std::vector<Edge> edges = randomChain(seed, 300);
    std::string text;
    for (const Edge& edge : edges) text += edgeText(edge);
    const EdgeFile file(text);
    const auto poses = readDrive(file.path);
    REQUIRE(poses.isOk());
    REQUIRE(poses.value().poses.size() == 301);
    Eigen::Isometry2d T = Eigen::Isometry2d::Identity();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const PlanarPose& m = edges[i].motion;
      T = T * Eigen::Translation2d(m.x, m.y) * Eigen::Rotation2Dd(m.theta);
      const PlanarPose& pose = poses.value().poses[i + 1];
      REQUIRE(pose.x == Approx(T.translation().x()).margin(1e-9));
      REQUIRE(pose.y == Approx(T.translation().y()).margin(1e-9));
      REQUIRE(std::cos(pose.theta) == Approx(T.linear()(0, 0)).margin(1e-9));
      REQUIRE(std::sin(pose.theta) == Approx(T.linear()(1, 0)).margin(1e-9));
    }
  }
}

TEST_CASE("a line with too few, wild or wrong numbers is refused by its number") {
  for (const char* line : {"EDGE_SE2", "EDGE_SE2 0 1", "EDGE_SE2 0 1 1 0", "EDGE_SE2 0 1 nan 0 0",
                           "EDGE_SE2 0 1 0 inf 0", "EDGE_SE2 0 1 0 0 1e400", "EDGE_SE2 -1 0 0 0 0",
                           "EDGE_SE2 0 -1 0 0 0", "EDGE_SE2 0 99999999999999999999 0 0 0",
                           "EDGE_SE2 0.5 1 0 0 0", "EDGE_SE2 0 1 1,5 0 0", "EDGE_SE2 a b c d e"}) {
    const EdgeFile file(std::string("EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n\n") + line + "\n");
    CAPTURE(line);
    CHECK(file.refusal() ==
          ":3: needs two ids from 0 and three numbers (dx dy dtheta) of at most 1e9; correct it");
  }
  for (const char* line : {"edge_se2 0 1 1 0 0", "0 1 1 0 0", "\xff\xfe", "EDGE2 0 1 1 0 0"}) {
    const EdgeFile file(std::string("# first\n") + line);
    CAPTURE(line);
    CHECK(file.refusal() ==
          ":2: is no line of a g2o file (EDGE_SE2, EDGE_SE3:QUAT, VERTEX_..., FIX)");
  }
  CHECK(
      EdgeFile("EDGE_SE3:QUAT 0 1 1 0 0 0 0 1").refusal() ==
      ":1: needs two ids from 0 and seven numbers (x y z qx qy qz qw) of at most 1e9; correct it");
  CHECK(EdgeFile("EDGE_SE3:QUAT 0 1 1 0 0 0 0 1 1").refusal() ==
        ":1: has no unit quaternion (qx qy qz qw); correct it");
}

TEST_CASE("six information values of a positive definite matrix are demanded") {
  const std::string edge = "EDGE_SE2 0 1 1 0 0 ";
  for (const auto& [values, count] :
       {std::pair("", 0), std::pair("1", 1), std::pair("1 0 0 1 0", 5),
        std::pair("1 0 0 1 0 1 1", 7), std::pair("1 0 0 1 0 1 # comment", 8)}) {
    const EdgeFile file("\n" + edge + values + "\n");
    CHECK(file.refusal() == ":2: has " + std::to_string(count) +
                                " information values instead of six after dx dy dtheta; the file "
                                "may be cut off");
  }
  for (const char* values :
       {"1 0 0 1 0 x", "1 0 0 1 0 1x", "nan 0 0 1 0 1", "1 0 0 1 0 -", "1 0 0 1 0 1e999"}) {
    CAPTURE(values);
    CHECK(EdgeFile(edge + values).refusal() ==
          ":1: has an information value that is no number; correct it");
  }
  // Zero, negative, and matrices with one eigenvalue of 0 or below.
  for (const char* values :
       {"0 0 0 0 0 0", "-1 0 0 -1 0 -1", "1 0 0 1 0 0", "1 0 0 0 0 1", "0 0 0 1 0 1", "1 1 0 1 0 1",
        "1 2 0 1 0 1", "1 0 2 1 0 1", "1 0 0 1 -2 1", "1 0.8 0.8 1 -0.8 1"}) {
    CAPTURE(values);
    CHECK(EdgeFile(edge + values).refusal() ==
          ":1: has information values that are no positive definite matrix; write 1 0 0 1 0 1 "
          "where it is not known");
  }
}

TEST_CASE("positive definite means that every eigenvalue is positive") {
  RandomStream random(5);
  int definite = 0;
  for (int i = 0; i < 300; ++i) {
    const double shift = random.uniform(-1, 2);
    Eigen::Matrix3d M;
    for (double& number : M.reshaped()) number = random.normal();
    M = (M + M.transpose() + shift * Eigen::Matrix3d::Identity()).eval();
    std::ostringstream text;
    text << std::setprecision(17) << "EDGE_SE2 0 1 1 0 0 " << M(0, 0) << ' ' << M(0, 1) << ' '
         << M(0, 2) << ' ' << M(1, 1) << ' ' << M(1, 2) << ' ' << M(2, 2);
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(M).eigenvalues().x();
    if (std::abs(least) < 1e-9) continue;
    definite += least > 0 ? 1 : 0;
    REQUIRE(readGraph(EdgeFile(text.str()).path).isOk() == (least > 0));
  }
  CHECK(definite > 10);
}

TEST_CASE("a byte order mark is no part of the first line") {
  const EdgeFile file(
      "\xEF\xBB\xBF"
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n");
  CHECK(readGraph(file.path).value().edges.size() == 1);
}

TEST_CASE("every recorded motion of the real sequences is accepted", "[data]") {
  for (const char* name : {"00", "02", "05", "06", "07"}) {
    const auto folder = test::dataOrSkip(std::string("kitti_motion/") + name);
    if (!folder) return;
    for (const char* file : {"odometry.g2o", "ground_truth.g2o"}) {
      const auto chain = readDrive(*folder / file);
      INFO(chain.status().message());
      CHECK(chain.isOk());
    }
    CHECK(readGraph(*folder / "loop_candidates.g2o").isOk());
  }
}

TEST_CASE("fixed poses, parameters and comments are passed over, landmarks are counted") {
  const EdgeFile file(
      "VERTEX_SE2 0 0 0 0\nFIX 0\n#EDGE_SE2\n\n  \nVERTEX_TRACKXYZ 3\nPARAMS_SE2OFFSET 0\n"
      "EDGE_SE2_XY 0 3 1 1 1 0 1\nEDGE_SE2_XY 0 3 1 1 1 0 1\n");
  const auto graph = readGraph(file.path);
  REQUIRE(graph.isOk());
  CHECK(graph.value().edges.empty());
  REQUIRE(graph.value().findings.size() == 1);
  CHECK(graph.value().findings[0].message.starts_with("has 2 EDGE_SE2_XY, which are not used"));
  CHECK(readDrive(file.path).status().message() == file.path.string() + " has no edges");
}

TEST_CASE("a published graph is a drive: any order, ids and directions, with its loops") {
  // Ids 7, 8, 9, 12. The second step is written backwards, the loop comes first.
  const std::string end = " 1 0 0 1 0 1\n";
  const EdgeFile file("EDGE_SE2 7 12 0.1 0.2 0.3" + end + "EDGE_SE2 9 12 2 0 0.5" + end +
                      "EDGE_SE2 9 8 0 1 -1.5707963267948966" + end + "EDGE_SE2 7 8 1 0 0" + end +
                      "EDGE_SE2 7 8 9 9 0" + end);
  const auto drive = readDrive(file.path);
  INFO(drive.status().message());
  REQUIRE(drive.isOk());
  CHECK(drive.value().ids == std::vector<std::int64_t>{7, 8, 9, 12});
  const std::vector<PlanarPose>& poses = drive.value().poses;
  REQUIRE(poses.size() == 4);
  CHECK(poses[1].x == 1);
  CHECK(poses[2].x == Approx(2));  // one metre on and turned to the left
  CHECK(poses[2].y == Approx(0).margin(1e-12));
  CHECK(poses[2].theta == Approx(std::acos(0)));
  CHECK(poses[3].y == Approx(2));
  REQUIRE(drive.value().others.size() == 1);
  CHECK(drive.value().others[0].to == 12);
  REQUIRE(drive.value().findings.size() == 1);
  CHECK(drive.value().findings[0].message.starts_with("has 1 more edges between successive"));
}

TEST_CASE("vertices give the motion where no edge does, and nothing else") {
  const std::string chain = "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 2 3 1 0 0 1 0 0 1 0 1\n";
  CHECK(
      readDrive(EdgeFile(chain).path)
          .status()
          .message()
          .ends_with(": no edge leads from 1 to 2, and there are no vertices of the two; add one"));
  const EdgeFile file("VERTEX_SE2 0 5 5 0\nVERTEX_SE2 1 9 9 0\nVERTEX_SE2 2 9 9.5 0\n" + chain);
  const auto drive = readDrive(file.path);
  REQUIRE(drive.isOk());
  CHECK(drive.value().poses[2].x == Approx(1));
  CHECK(drive.value().poses[2].y == Approx(0.5));
  CHECK(drive.value().findings.size() == 1);
}

TEST_CASE("spatial graphs are planar motion, in the axes of a vehicle or of a camera") {
  // 2 m on and a turn of 0.6 rad to the left: about z upwards, or about y downwards.
  std::string unit;
  for (int row = 0; row < 6; ++row) unit += " 1" + std::string(row < 5 ? 5 - row : 0, 'o');
  std::string information;
  for (const char letter : unit) information += letter == 'o' ? " 0" : std::string(1, letter);
  const std::string vehicle = "2 0 0.1 0 0 0.29552020666 0.95533648913";
  const std::string camera = "0 -0.1 2 0 -0.29552020666 0 0.95533648913";
  for (const std::string& step : {vehicle, camera}) {
    const EdgeFile file("EDGE_SE3:QUAT 0 1 " + step + information + "\nEDGE_SE3:QUAT 1 2 " + step +
                        information + "\n");
    const auto drive = readDrive(file.path);
    INFO(drive.status().message());
    REQUIRE(drive.isOk());
    const PlanarPose end = drive.value().poses.at(2);
    CHECK(end.x == Approx(2 + 2 * std::cos(0.6)));
    CHECK(end.y == Approx(2 * std::sin(0.6)));
    CHECK(end.theta == Approx(1.2));
    REQUIRE(drive.value().findings.size() == 1);
    CHECK(drive.value().findings[0].severity == Finding::Severity::Note);  // 5 % are flat
  }
}

TEST_CASE("folders, pipes and files that are not there are refused without waiting") {
  const test::TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  for (const std::filesystem::path& path : {folder.path(), pipe, folder.path() / "nothing"}) {
    CHECK(readGraph(path).status().message().ends_with("correct the path"));
  }
}

TEST_CASE("values that a double cannot hold are refused, a plus sign is not") {
  CHECK(EdgeFile("EDGE_SE2 0 1 1e-400 0 0 1 0 0 1 0 1\n").refusal() ==
        ":1: '1e-400' is too small for a double (write 0); correct it");
  CHECK(EdgeFile("EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1e-999\n").refusal() ==
        ":1: '1e-999' is too small for a double (write 0); correct it");
  CHECK(EdgeFile("EDGE_SE2 0 1 1x 0 0 1 0 0 1 0 1\n").refusal().starts_with(":1: needs two ids"));
  const EdgeFile plus("EDGE_SE2 0 1 +1.5 -0.5 +0.1 +1 0 0 1 0 1\n");
  const auto edges = readGraph(plus.path);
  REQUIRE(edges.isOk());
  CHECK(edges.value().edges.at(0).motion.x == 1.5);
  CHECK(edges.value().edges.at(0).motion.theta == 0.1);
}

}  // namespace tolman::motion_log
