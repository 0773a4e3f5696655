// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/metrics.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "evaluation/paths.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

Scores scoresOf(const Trajectory& truth, const Trajectory& estimate, Alignment alignment) {
  const TrajectoryMetrics metrics = score(truth, estimate, alignment);
  INFO(metrics.reason);
  REQUIRE(metrics.scores);
  return *metrics.scores;
}

}  // namespace

TEST_CASE("metrics.json has the promised keys with the right figures") {
  const Trajectory truth = test::straightPath(100);
  Trajectory bent = truth;
  for (auto& pose : bent) pose.T_world_camera.translation().x() += pose.frame % 2 == 0 ? 0.1 : -0.1;
  Metrics metrics;
  metrics.odometry = score(truth, bent, Alignment::Se3);
  bent.resize(80);
  metrics.map = score(truth, bent, Alignment::Se3);
  metrics.frames = 100;
  metrics.templates = 7;
  metrics.counts = {9, 12, 2, 1, 5};
  metrics.timing["odometry"] = stageTiming({1'000'000, 3'000'000});
  const auto json = toJson(metrics);
  CHECK(json["alignment"] == "se3");
  CHECK(json["odometry"]["ate"]["rmse_m"].get<double>() == Approx(0.1).epsilon(1e-3));
  for (const char* key : {"rmse_m", "mean_m", "median_m", "min_m", "max_m"}) {
    CHECK(json["map"]["ate"][key].is_number());
  }
  CHECK(json["odometry"]["rpe"]["frame"]["translation"]["rmse_m"].get<double>() ==
        Approx(0.2).epsilon(1e-3));
  CHECK(json["odometry"]["rpe"]["metre"]["rotation"]["rmse_deg_per_m"].get<double>() < 1e-3);
  CHECK(json["odometry"]["kitti"]["t_rel_percent"].is_number());
  CHECK(json["odometry"]["kitti"]["r_rel_deg_per_100m"].is_number());
  CHECK(json["odometry"]["kitti"]["lengths"] == "short");
  CHECK(json["odometry"]["kitti"]["lengths_m"] == std::vector<double>{5, 10, 20, 30, 40, 50});
  // Starts every 10 m of 99 m: 10 of 5 m, 9 of 10 m, 8 of 20 m, 7 of 30 m, 6 of 40 m, 5 of 50 m.
  CHECK(json["odometry"]["kitti"]["segments"] == 45);
  CHECK(json["odometry"]["matched"] == 100);
  CHECK(json["odometry"]["coverage"] == 1.0);
  CHECK(json["map"]["coverage"] == 0.8);
  CHECK(json["coverage"] == 0.8);
  CHECK(json["odometry"]["reason"].is_null());
  CHECK(json["templates"] == 7);
  CHECK(json["experiences"] == 9);
  CHECK(json["links"] == 12);
  CHECK(json["loop_links"] == 2);
  CHECK(json["rejected_loop_links"] == 1);
  CHECK(json["loop_decisions"] == 5);
  CHECK(json["timing"]["odometry"]["mean_ms"] == 2.0);
}

TEST_CASE("one pose that matches has no aligned error, as any pose can be put on any other") {
  const Trajectory truth = test::straightPath(30);
  Trajectory one = test::straightPath(1);
  one[0].T_world_camera.translation().x() = 3;
  for (const Alignment alignment : {Alignment::Se2, Alignment::Se3, Alignment::Sim3}) {
    const TrajectoryMetrics metrics = score(truth, one, alignment);
    CHECK(metrics.matched == 1);
    CHECK_FALSE(metrics.scores);
    CHECK(metrics.reason ==
          "only one pose matches; any one is aligned without an error, so give more");
  }
  CHECK(scoresOf(truth, one, Alignment::None).ate_m.rmse == 3);
  CHECK(score(truth, test::straightPath(2), Alignment::Se3).scores);
}

TEST_CASE("without truth the scores are null with a reason, the path length is not") {
  Metrics metrics;
  metrics.odometry = score({}, test::straightPath(11), Alignment::Se3);
  metrics.map = score(test::straightPath(3), {}, Alignment::Se3);
  const auto json = toJson(metrics);
  CHECK(json["odometry"]["ate"]["rmse_m"].is_null());
  CHECK(json["odometry"]["rpe"]["frame"]["translation"]["rmse_m"].is_null());
  CHECK(json["odometry"]["kitti"]["t_rel_percent"].is_null());
  CHECK(json["odometry"]["reason"] == "there is no ground truth");
  CHECK(json["odometry"]["path_length_m"].get<double>() == Approx(10));
  CHECK(json["odometry"]["matched"] == 0);
  CHECK(json["map"]["reason"] == "there is no estimate");
  CHECK(json["coverage"].is_null());
}

TEST_CASE("a path that is too short for segments says so") {
  const auto metrics = score(test::straightPath(4), test::straightPath(4), Alignment::Se3);
  const auto json = toJson(metrics);
  CHECK(json["kitti"]["t_rel_percent"].is_null());
  CHECK(json["kitti"]["reason"] == "the path is shorter than any segment");
  CHECK(json["ate"]["rmse_m"].get<double>() < 1e-9);
}

TEST_CASE("the error is told apart by horizontal and vertical; both give the whole") {
  RandomStream random(9);
  const Trajectory truth = test::wanderingPath(50, random);
  Trajectory estimate = truth;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const double sign = i % 2 == 0 ? 1 : -1;
    estimate[i].T_world_camera.translation() += sign * Eigen::Vector3d(3, 12, 4);
  }
  const Scores scores = scoresOf(truth, estimate, Alignment::None);
  CHECK(scores.ate_m.rmse == Approx(13));
  CHECK(scores.horizontal_m.rmse == Approx(5));
  CHECK(scores.vertical_m.rmse == Approx(12));
  const auto json = toJson(score(test::straightPath(50), estimate, Alignment::Se2));
  CHECK(json["ate"] == json["ate_horizontal"]);
  CHECK(json["ate_vertical"]["rmse_m"].is_null());
  CHECK(json["ate_vertical"]["reason"] == "se2 compares on the plane");
}

TEST_CASE("relative errors that have no pairs say why") {
  const Trajectory truth = test::straightPath(50);
  Trajectory every_second;
  for (std::size_t i = 0; i < truth.size(); i += 2) every_second.push_back(truth[i]);
  const auto json = toJson(score(truth, every_second, Alignment::Se3));
  CHECK(json["rpe"]["frame"]["translation"]["rmse_m"].is_null());
  CHECK(json["rpe"]["frame"]["pairs"] == 0);
  CHECK(json["rpe"]["frame"]["reason"] == "no two poses that match are one frame apart");
  CHECK(json["rpe"]["metre"]["reason"].is_null());
  const Trajectory slow = test::straightPath(50, 0.01);
  const auto crept = toJson(score(slow, slow, Alignment::Se3));
  CHECK(crept["rpe"]["frame"]["reason"].is_null());
  CHECK(crept["rpe"]["metre"]["reason"] == "the path is shorter than 1 m");
  CHECK(toJson(score({}, truth, Alignment::Se3))["rpe"]["metre"]["reason"].is_null());
}

TEST_CASE("verdicts: false loops, a worse map, no motion, no place seen again") {
  const Trajectory truth = test::straightPath(100);
  Trajectory bent = truth;
  for (auto& pose : bent) pose.T_world_camera.translation().x() += pose.frame % 2 == 0 ? 0.1 : -0.1;
  Metrics metrics;
  metrics.frames = 100;
  metrics.odometry = metrics.map = score(truth, truth, Alignment::Se3);
  CHECK(verdictsOf(metrics) == std::vector<std::string>{"no loop was closed"});
  metrics.map = score(truth, bent, Alignment::Se3);
  metrics.counts.loop_links = 5;
  metrics.counts.rejected_loop_links = 1;
  metrics.loops = LoopFigures{.true_links = 3, .false_links = 2};
  metrics.returns = false;
  const auto verdicts = verdictsOf(metrics);
  REQUIRE(verdicts.size() == 3);
  CHECK(verdicts[0] == "5 loop links, 2 of them FALSE; the map rejected 1");
  CHECK(verdicts[1] == "the map is WORSE than its odometry: 0.100 m against 0.000 m");
  CHECK(verdicts[2] ==
        "this recording never returns to a place: cells and map cannot be compared on it");
  metrics.odometry.path_length_m = 0.02;
  CHECK(verdictsOf(metrics)[0] ==
        "the camera did not move, or no motion was found: the path of odometry is 0.020 m");
}

TEST_CASE("planar alignment scores the plane, Sim(3) reports its scale") {
  RandomStream random(4);
  Trajectory truth = test::wanderingPath(50, random);
  truth = test::moved(truth, truth.front().T_world_camera.inverse());
  for (auto& pose : truth) pose.T_world_camera.translation().y() *= 0.1;  // hills
  Trajectory flat = truth;
  for (auto& pose : flat) pose.T_world_camera.translation().y() = 0;
  CHECK(scoresOf(truth, flat, Alignment::Se2).ate_m.max < 1e-9);
  CHECK(scoresOf(truth, flat, Alignment::None).ate_m.max > 0.1);
  const auto scaled =
      score(truth, test::moved(truth, Eigen::Isometry3d::Identity(), 0.5), Alignment::Sim3);
  CHECK(scaled.scores->scale == Approx(2));
  CHECK(scaled.path_length_m == Approx(pathLength(truth)));
  // Relative errors are measured with the scale applied.
  CHECK(scaled.scores->rpe_frame.translation_m.max < 1e-9);
}

TEST_CASE("accepted and rejected loop links are counted apart") {
  MapGraph graph;
  graph.experiences.resize(4);
  graph.links.resize(6);
  for (std::size_t i = 0; i < 6; ++i) {
    graph.links[i].id = static_cast<std::int64_t>(i);
    graph.links[i].kind = i < 3 ? LinkKind::Odometry : LinkKind::Loop;
  }
  graph.rejected = {5};
  const MapCounts counts = countsOf(graph, 7);
  CHECK(counts.experiences == 4);
  CHECK(counts.links == 5);
  CHECK(counts.loop_links == 2);
  CHECK(counts.rejected_loop_links == 1);
  CHECK(counts.loop_decisions == 7);
}

TEST_CASE("timing by hand") {
  std::vector<std::int64_t> durations;
  for (std::int64_t i = 100; i >= 1; --i) durations.push_back(i * 1'000'000);
  const StageTiming timing = stageTiming(durations);
  CHECK(timing.frames == 100);
  CHECK(timing.mean_ms == Approx(50.5));
  CHECK(timing.median_ms == Approx(50.5));
  CHECK(timing.p95_ms == Approx(95));
  CHECK(timing.max_ms == Approx(100));
  CHECK(stageTiming({}).frames == 0);
}

TEST_CASE("se2 compares on the plane of the first camera, whatever the axes of the world are") {
  RandomStream random(7);
  Trajectory truth = test::straightPath(60);
  for (auto& pose : truth) {
    pose.T_world_camera.translation().x() = 0.02 * static_cast<double>(pose.frame * pose.frame);
  }
  Trajectory estimate = truth;
  for (auto& pose : estimate) {
    pose.T_world_camera.translation().z() *= 1.02;
    pose.T_world_camera.translation().y() = pose.frame % 2 == 0 ? 0.3 : -0.3;
  }
  const TrajectoryMetrics level = score(truth, estimate, Alignment::Se2);
  REQUIRE(level.scores);
  CHECK(level.scores->ate_m.rmse > 0.1);
  const Eigen::Isometry3d z_up(
      Eigen::AngleAxisd(-0.5 * std::numbers::pi, Eigen::Vector3d::UnitX()));
  for (const Eigen::Isometry3d& T_other_world : {z_up, test::randomPose(random)}) {
    const TrajectoryMetrics turned =
        score(test::moved(truth, T_other_world), estimate, Alignment::Se2);
    REQUIRE(turned.scores);
    CHECK(turned.scores->ate_m.rmse == Approx(level.scores->ate_m.rmse));
    const TrajectoryMetrics whole =
        score(test::moved(truth, T_other_world), estimate, Alignment::Se3);
    REQUIRE(whole.scores);
    CHECK(whole.scores->vertical_m.rmse ==
          Approx(scoresOf(truth, estimate, Alignment::Se3).vertical_m.rmse));
  }
}

TEST_CASE("se2 refuses a path that leaves its plane") {
  Trajectory truth = test::straightPath(30);
  for (auto& pose : truth) {
    auto position = pose.T_world_camera.translation();
    position = Eigen::Vector3d(0, position.z(), 0);
  }
  Trajectory half = truth;
  for (auto& pose : half) pose.T_world_camera.translation() *= 0.5;
  const TrajectoryMetrics metrics = score(truth, half, Alignment::Se2);
  CHECK_FALSE(metrics.scores);
  CHECK(metrics.reason ==
        "se2 compares on the x-z plane of the first true pose (camera axes: x right, y down, z "
        "forward), but the truth moves 29 m along that pose's y axis and only 0 m in the plane; "
        "use se3, or give the truth as poses of a level camera");
  CHECK(scoresOf(truth, half, Alignment::Se3).ate_m.rmse > 4);
}
