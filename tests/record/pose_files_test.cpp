// SPDX-License-Identifier: BSD-3-Clause
// Trajectories as text.
#include <numbers>

#include "record/by_hand.hpp"
#include "record/export.hpp"
#include "record/sample_run.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

evaluation::TrajectoryPose poseAt(std::int64_t frame, std::int64_t stamp_ns, double z) {
  evaluation::TrajectoryPose pose{frame, stamp_ns, Eigen::Isometry3d::Identity()};
  pose.T_world_camera.translation().z() = z;
  return pose;
}

/// Random poses of frames 0, 1 ... at odd times.
evaluation::Trajectory randomPoses(std::size_t count) {
  RandomStream random(63);
  evaluation::Trajectory poses;
  std::int64_t stamp_ns = 1'403'636'579'763'555'527;
  for (std::size_t i = 0; i < count; ++i) {
    stamp_ns += 1 + static_cast<std::int64_t>(random.below(2'000'000'000));
    poses.push_back({static_cast<std::int64_t>(i), stamp_ns, test::randomPose(random)});
  }
  return poses;
}

}  // namespace

TEST_CASE("a TUM file keeps stamps exactly") {
  const evaluation::Trajectory poses = {poseAt(0, 1403636579763555527, 0.1), poseAt(1, 5, -2),
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
  std::istringstream words(tumText(evaluation::Trajectory{{0, 0, T}}));
  std::vector<double> v{std::istream_iterator<double>(words), {}};
  REQUIRE(v.size() == 8);
  CHECK(v[5] == Approx(-std::sqrt(0.5)));
  CHECK(v[7] == Approx(std::sqrt(0.5)));
}

TEST_CASE("a KITTI file has one line a frame, also for frames that were dropped") {
  const evaluation::Trajectory poses = {poseAt(1, 0, 1), poseAt(3, 0, 3)};
  CHECK(kittiText(poses) ==
        "1 0 0 0 0 1 0 0 0 0 1 0\n"  // frame 0: nothing known yet
        "1 0 0 0 0 1 0 0 0 0 1 1\n"
        "1 0 0 0 0 1 0 0 0 0 1 1\n"  // frame 2: as before
        "1 0 0 0 0 1 0 0 0 0 1 3\n");
  const std::string line = "1 0 0 0 0 1 0 0 0 0 1 3\n";
  CHECK(kittiText(poses, 6) == kittiText(poses) + line + line);
  CHECK(kittiText(poses, 2) == kittiText(poses));
}

TEST_CASE("the earliest time that there is can be written") {
  CHECK(tumText(std::vector{poseAt(0, INT64_MIN, 0)}).starts_with("-9223372036.854775808 "));
  CHECK(tumText(std::vector{poseAt(0, INT64_MAX, 0)}).starts_with("9223372036.854775807 "));
}

TEST_CASE("a TUM file reads back: stamps and positions exactly, rotations to rounding") {
  const evaluation::Trajectory poses = randomPoses(200);
  const auto lines = test::linesOf(tumText(poses));
  REQUIRE(lines.size() == poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    std::string stamp = test::wordsOf(lines[i]).front();
    stamp.erase(stamp.find('.'), 1);  // nine decimals: without the point it is nanoseconds
    CHECK(std::stoll(stamp) == poses[i].stamp_ns);
    const std::vector<double> v = test::numbersOf(lines[i]);
    REQUIRE(v.size() == 8);
    CHECK(Eigen::Vector3d(v[1], v[2], v[3]) == poses[i].T_world_camera.translation());
    const Eigen::Quaterniond q(v[7], v[4], v[5], v[6]);
    CHECK(q.norm() == Approx(1).epsilon(1e-15));
    CHECK((q.toRotationMatrix() - poses[i].T_world_camera.linear()).norm() < 1e-14);
  }
}

TEST_CASE("a KITTI file reads back exactly: the upper three rows of each matrix") {
  const evaluation::Trajectory poses = randomPoses(200);
  const auto lines = test::linesOf(kittiText(poses));
  REQUIRE(lines.size() == poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::vector<double> v = test::numbersOf(lines[i]);
    REQUIRE(v.size() == 12);
    for (int cell = 0; cell < 12; ++cell) {
      CHECK(v[static_cast<std::size_t>(cell)] ==
            poses[i].T_world_camera.matrix()(cell / 4, cell % 4));
    }
  }
}
