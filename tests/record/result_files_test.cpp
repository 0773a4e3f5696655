// SPDX-License-Identifier: BSD-3-Clause
// Trajectories, map, digests and atomic writes.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <iterator>
#include <sstream>

#include "record/atomic_file.hpp"
#include "record/digest.hpp"
#include "record/export.hpp"
#include "record/g2o_file.hpp"
#include "record/pose_files.hpp"
#include "record/sample_run.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t filesIn(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

StampedPose poseAt(std::int64_t frame, std::int64_t stamp_ns, double z) {
  StampedPose pose{frame, stamp_ns, Eigen::Isometry3d::Identity()};
  pose.T_world_camera.translation().z() = z;
  return pose;
}

void recordRun(const std::filesystem::path& folder, std::int64_t frames) {
  auto recorder = Recorder::open(folder).value();
  for (std::int64_t i = 0; i < frames; ++i) REQUIRE(test::recordFrame(*recorder, i).isOk());
  REQUIRE(recorder->timing(0, "odometry", static_cast<std::int64_t>(getpid()) + frames).isOk());
  REQUIRE(recorder->close().isOk());
}

}  // namespace

TEST_CASE("a TUM file keeps stamps exactly") {
  const std::vector<StampedPose> poses = {poseAt(0, 1403636579763555527, 0.1), poseAt(1, 5, -2),
                                          poseAt(2, -1, 1e-7)};
  CHECK(tumText(poses) ==
        "1403636579.763555527 0 0 0.1 0 0 0 1\n"
        "0.000000005 0 0 -2 0 0 0 1\n"
        "-0.000000001 0 0 1e-07 0 0 0 1\n");
}

TEST_CASE("numbers read back exactly, and there is no negative zero") {
  RandomStream random(61);
  for (int i = 0; i < 1000; ++i) {
    const double value = random.normal() * std::pow(10, random.uniform(-20, 20));
    CHECK(std::stod(numberText(value)) == value);
  }
  CHECK(numberText(-0.0) == "0");
}

TEST_CASE("quaternions are written with w >= 0") {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(1.5 * std::numbers::pi, Eigen::Vector3d::UnitY()).matrix();
  std::istringstream words(poseText(T));
  std::vector<double> v{std::istream_iterator<double>(words), {}};
  REQUIRE(v.size() == 7);
  CHECK(v[4] == Approx(-std::sqrt(0.5)));
  CHECK(v[6] == Approx(std::sqrt(0.5)));
}

TEST_CASE("a KITTI file has one line a frame, also for frames that were dropped") {
  const std::vector<StampedPose> poses = {poseAt(1, 0, 1), poseAt(3, 0, 3)};
  CHECK(kittiText(poses).value() ==
        "1 0 0 0 0 1 0 0 0 0 1 0\n"  // frame 0: nothing known yet
        "1 0 0 0 0 1 0 0 0 0 1 1\n"
        "1 0 0 0 0 1 0 0 0 0 1 1\n"  // frame 2: as before
        "1 0 0 0 0 1 0 0 0 0 1 3\n");
  const std::vector<StampedPose> damaged = {poseAt(0, 0, 0), poseAt(1LL << 60, 0, 0)};
  CHECK(kittiText(damaged).status().message() ==
        "frame 1152921504606846976 comes where frame 1 was due; the record is damaged");
  CHECK_FALSE(kittiText(std::vector<StampedPose>{poseAt(-1, 0, 0)}).isOk());
}

TEST_CASE("a g2o file: vertices, the fixed one, edges with 21 values") {
  const MapGraph graph{1,
                       {test::experienceAt(0, 0, 0), test::experienceAt(1, 2, 2)},
                       {test::linkBetween(0, 0, 1, 2)}};
  CHECK(g2oText(graph) ==
        "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n"
        "VERTEX_SE3:QUAT 1 0 0 2 0 0 0 1\n"
        "FIX 0\n"
        "EDGE_SE3:QUAT 0 1 0 0 2 0 0 0 1"
        " 4 0 0 0 0 0 4 0 0 0 0 4 0 0 0 16 0 0 16 0 16\n");
  CHECK(g2oText({}).empty());
}

TEST_CASE("the g2o information gives every small motion the same cost as our covariance") {
  RandomStream random(62);
  Link link = test::linkBetween(0, 0, 1, 0);
  Matrix6d root;
  for (double& entry : root.reshaped()) entry = random.normal();
  link.covariance = root * root.transpose();
  link.weight = 0.5;
  const Matrix6d information = g2oInformation(link);
  for (int i = 0; i < 20; ++i) {
    Vector6d twist;
    for (double& entry : twist) entry = 1e-5 * random.normal();
    // g2o's error of the motion exp(twist): translation and the quaternion's vector part.
    const Eigen::Isometry3d T = expSe3(twist);
    Vector6d error;
    error << T.translation(), Eigen::Quaterniond(T.linear()).vec();
    const double ours = 0.5 * twist.dot(link.covariance.inverse() * twist);
    CHECK(error.dot(information * error) == Approx(ours).epsilon(1e-3));
  }
  link.covariance.setZero();  // no inverse
  CHECK(g2oInformation(link).allFinite());
}

TEST_CASE("atomic writes replace whole files and leave nothing behind") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "a.txt";
  REQUIRE(writeAtomically(file, "old").isOk());
  REQUIRE(writeAtomically(file, "new").isOk());
  CHECK(contentOf(file) == "new");
  CHECK(filesIn(folder.path()) == 1);
  CHECK_FALSE(writeAtomically(folder.path() / "absent" / "a.txt", "x").isOk());
}

TEST_CASE("a write that fails leaves the old file and no temporary one") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "a.txt";
  REQUIRE(writeAtomically(file, "old").isOk());
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    const Status status = writeAtomically(file, std::string(5000, 'x'));
    _exit(
        status.message().find("a.txt: cannot be written; look for a full disk (File too large)") !=
                std::string::npos
            ? 0
            : 1);
  }
  int result = 0;
  waitpid(child, &result, 0);
  CHECK((WIFEXITED(result) && WEXITSTATUS(result) == 0));
  CHECK(contentOf(file) == "old");
  CHECK(filesIn(folder.path()) == 1);
}

TEST_CASE("a run exports from its database alone") {
  const test::TemporaryFolder folder;
  recordRun(folder.path(), 3);
  const auto out = folder.path() / "out";
  std::filesystem::create_directory(out);
  REQUIRE(exportRun(folder.path(), out).value().size() == 5);
  CHECK(contentOf(out / "odometry.tum") ==
        "1.000000000 0 0 0 0 0 0 1\n1.100000000 0 0 1 0 0 0 1\n1.200000000 0 0 2 0 0 0 1\n");
  CHECK(contentOf(out / "trajectory.tum") == contentOf(out / "odometry.tum"));
  CHECK(contentOf(out / "trajectory.kitti").substr(0, 24) == "1 0 0 0 0 1 0 0 0 0 1 0\n");
  CHECK(contentOf(out / "map.g2o") == "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nFIX 0\n");
  CHECK_FALSE(exportRun(folder.path(), out, {"map.dwg"}).isOk());
  CHECK_FALSE(exportRun(out, out).isOk());
}

TEST_CASE("an empty run has nothing to export, and says so") {
  const test::TemporaryFolder folder;
  recordRun(folder.path(), 0);
  CHECK(exportRun(folder.path(), folder.path()).status().message() ==
        folder.path().string() + ": holds nothing to export yet");
}

TEST_CASE("equal runs have equal digests, whatever time they took; others have not") {
  const test::TemporaryFolder one;
  const test::TemporaryFolder two;
  const test::TemporaryFolder three;
  recordRun(one.path(), 5);
  recordRun(two.path(), 5);
  recordRun(three.path(), 6);
  CHECK(databaseDigest(one.path()).value() == databaseDigest(two.path()).value());
  CHECK(databaseDigest(one.path()).value() != databaseDigest(three.path()).value());
}

TEST_CASE("results.sha256 is what sha256sum understands") {
  const test::TemporaryFolder folder;
  recordRun(folder.path(), 3);
  REQUIRE(exportRun(folder.path(), folder.path()).isOk());
  REQUIRE(writeResultsDigest(folder.path()).isOk());
  const std::string check =
      "cd '" + folder.path().string() + "' && sha256sum --quiet -c results.sha256";
  CHECK(std::system(check.c_str()) == 0);
  const std::string lines = contentOf(folder.path() / "results.sha256");
  CHECK(std::count(lines.begin(), lines.end(), '\n') == 5);
}
