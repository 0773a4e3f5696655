// SPDX-License-Identifier: BSD-3-Clause
// Published figures of published estimates of KITTI 00.
#include <catch2/catch.hpp>

#include "evaluation/metrics.hpp"
#include "evaluation/trajectory_files.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

TrajectoryMetrics scoresOf(const std::filesystem::path& folder, const std::string& estimate) {
  const auto truth = readTrajectory(folder / "kitti_00_ground_truth.txt");
  REQUIRE(truth.isOk());
  return scoreTrajectory(truth.value(), readTrajectory(folder / estimate).value(), Alignment::Se3);
}

}  // namespace

TEST_CASE("ORB-SLAM2 stereo on KITTI 00: 1.303 m, 0.70 %, 0.25 deg/100 m", "[data]") {
  const auto folder = test::dataOrSkip("evo_reference");
  if (!folder) return;
  const TrajectoryMetrics metrics = scoresOf(*folder, "kitti_00_orb_slam2_stereo.txt");
  REQUIRE(metrics.scores);
  CHECK(metrics.matched == 4541);
  CHECK(metrics.scores->coverage == 1);
  CHECK(metrics.scores->ate_m.rmse == Approx(1.303).margin(0.0005));
  CHECK(metrics.scores->kitti.lengths.name == "kitti");
  CHECK(metrics.scores->kitti.t_rel_percent == Approx(0.70).margin(0.01));
  CHECK(metrics.scores->kitti.r_rel_deg_per_100m == Approx(0.25).margin(0.01));
  CHECK(metrics.path_length_m == Approx(3724).epsilon(0.01));
}

TEST_CASE("S-PTAM on KITTI 00: 3.738 m", "[data]") {
  const auto folder = test::dataOrSkip("evo_reference");
  if (!folder) return;
  const TrajectoryMetrics metrics = scoresOf(*folder, "kitti_00_sptam.txt");
  REQUIRE(metrics.scores);
  CHECK(metrics.scores->ate_m.rmse == Approx(3.738).margin(0.0005));
}
