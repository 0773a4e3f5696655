// SPDX-License-Identifier: BSD-3-Clause
// Published figures of published estimates, figures of others' tools, and no doubt about honest
// trajectories.
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "evaluation/metrics.hpp"
#include "evaluation/paths.hpp"
#include "evaluation/score.hpp"
#include "evaluation/step_series.hpp"
#include "evaluation/trajectory.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

Trajectory read(const std::filesystem::path& file) {
  auto path = readTrajectory(file);
  INFO(path.status().message());
  REQUIRE(path.isOk());
  return std::move(path).value();
}

/// Planar motions from frame to frame: EDGE_SE2 i i+1 dx dy dtheta ...
Trajectory readMotions(const std::filesystem::path& file) {
  std::ifstream stream(file);
  Trajectory path(1);
  PlanarPose pose;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string kind;
    std::int64_t from = 0, to = 0;
    PlanarPose step;
    words >> kind >> from >> to >> step.x >> step.y >> step.theta;
    if (kind != "EDGE_SE2") continue;
    pose = compose(pose, step);
    path.push_back({to, to * 100'000'000, fromPlanar(pose)});
  }
  REQUIRE(path.size() > 1000);
  return path;
}

std::string foundDoubts(const Trajectory& truth, const Trajectory& estimate,
                        std::int64_t max_difference_ns = -1) {
  const auto rule = max_difference_ns < 0 ? MatchRule::Order : MatchRule::Nearest;
  return doubtText(doubts(truth, estimate, {Alignment::Se3, {}, {rule, max_difference_ns}}));
}

}  // namespace

TEST_CASE("ORB-SLAM2 stereo on KITTI 00: 1.303 m, 0.70 %, 0.25 deg/100 m", "[data]") {
  const auto folder = test::dataOrSkip("evo_reference");
  if (!folder) return;
  const Trajectory truth = read(*folder / "kitti_00_ground_truth.txt");
  const Trajectory estimate = read(*folder / "kitti_00_orb_slam2_stereo.txt");
  const TrajectoryMetrics metrics = score(truth, estimate, Alignment::Se3);
  REQUIRE(metrics.scores);
  CHECK(metrics.matched == 4541);
  CHECK(metrics.scores->coverage == 1);
  CHECK(metrics.scores->ate_m.rmse == Approx(1.303).margin(0.0005));
  CHECK(metrics.scores->kitti.lengths.name == "kitti");
  CHECK(metrics.scores->kitti.t_rel_percent == Approx(0.70).margin(0.01));
  CHECK(metrics.scores->kitti.r_rel_deg_per_100m == Approx(0.25).margin(0.01));
  CHECK(metrics.path_length_m == Approx(3724).epsilon(0.01));
  CHECK(foundDoubts(truth, estimate).empty());
}

TEST_CASE("S-PTAM on KITTI 00: 3.738 m", "[data]") {
  const auto folder = test::dataOrSkip("evo_reference");
  if (!folder) return;
  const Trajectory truth = read(*folder / "kitti_00_ground_truth.txt");
  const Trajectory estimate = read(*folder / "kitti_00_sptam.txt");
  const TrajectoryMetrics metrics = score(truth, estimate, Alignment::Se3);
  REQUIRE(metrics.scores);
  CHECK(metrics.scores->ate_m.rmse == Approx(3.738).margin(0.0005));
  CHECK(foundDoubts(truth, estimate).empty());
}

TEST_CASE("real odometry and noise on real truths give no doubt", "[data]") {
  const auto motion = test::dataOrSkip("kitti_motion");
  const auto tum = test::dataOrSkip("tum_fr1_xyz");
  if (!motion || !tum) return;
  for (const char* sequence : {"00", "02", "05", "06", "07"}) {
    CAPTURE(sequence);
    const Trajectory truth = readMotions(*motion / sequence / "ground_truth.g2o");
    CHECK(foundDoubts(truth, readMotions(*motion / sequence / "odometry.g2o")) == "");
  }
  const Trajectory hand = read(*tum / "groundtruth.txt");
  for (const double metres : {0.0, 0.01, 0.1}) {
    CAPTURE(metres);
    RandomStream random(7);
    Trajectory noisy = hand;
    for (TrajectoryPose& pose : noisy) {
      for (double& value : pose.T_world_camera.translation()) value += metres * random.normal();
    }
    CHECK(foundDoubts(hand, noisy) == "");
    CHECK(doubtText(doubts(hand, noisy, Alignment::Sim3)) == "");
  }
}

TEST_CASE("truth of another point, body, clock or unit, and a restart, with their values",
          "[data]") {
  const auto folder = test::dataOrSkip("evo_reference/expected/inputs");
  if (!folder) return;
  const auto input = [&](const char* name) { return read(*folder / name); };
  const Trajectory truth = input("truth.tum"), noisy = input("noisy.tum");
  constexpr std::int64_t kNear = 50'000'000;
  CHECK(foundDoubts(truth, noisy).empty());
  CHECK(foundDoubts(input("body.tum"), input("noisy_zup.tum")).empty());
  for (const char* part : {"partial_truth.tum", "truth_1hz.tum", "truth_100hz.tum"}) {
    CHECK(foundDoubts(input(part), noisy, kNear / 2).empty());
  }
  CHECK(foundDoubts(truth, input("half.tum"), kNear / 2).empty());
  CHECK_THAT(foundDoubts(input("lever.tum"), truth),
             Catch::Contains("of a point at (0.200 +- 0.000"));
  CHECK_THAT(foundDoubts(input("body.tum"), noisy), Catch::Contains("turned by 120 degrees"));
  CHECK_THAT(foundDoubts(truth, input("scaled.tum")), Catch::Contains("is multiplied by 2.68"));
  CHECK_THAT(
      foundDoubts(truth, input("restart.tum")),
      Catch::StartsWith("from frame 599 to 600") && Catch::Contains("starts again at its origin"));
  for (const char* clock : {"truth.tum", "truth_100hz.tum"}) {
    CHECK_THAT(foundDoubts(input(clock), input("shifted.tum"), kNear),
               Catch::Contains("the clock of the estimate is 0.130 s ahead"));
  }

  const Extrinsic point = extrinsicOf(test::paired(input("lever.tum"), noisy), false);
  CHECK(point.arm.x() == Approx(0.2).margin(0.05));
  CHECK(point.arm.z() == Approx(-1.6).margin(0.05));
  CHECK(point.sigma.x() < 0.05);
  CHECK(point.sigma.z() < 0.05);
  const Extrinsic body = extrinsicOf(test::paired(input("body.tum"), noisy), true);
  CHECK(body.arm.x() == Approx(0.2).margin(0.05));
  CHECK(body.arm.z() == Approx(-1.6).margin(0.05));
  const Trajectory shifted = input("shifted.tum");
  const Matches matches = associate(truth, shifted, {MatchRule::Nearest, kNear}).value();
  CHECK(clockOffset(truth, matches).value().seconds == Approx(-0.13).margin(0.003));
}
