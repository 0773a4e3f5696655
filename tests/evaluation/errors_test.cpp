// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/errors.hpp"

#include <catch2/catch.hpp>

#include "evaluation/kitti_segments.hpp"
#include "evaluation/paths.hpp"

using namespace tolman;
using namespace tolman::evaluation;

TEST_CASE("statistics by hand") {
  const Statistics odd = statistics({3, 1, 8});
  CHECK(odd.count == 3);
  CHECK(odd.mean == Approx(4));
  CHECK(odd.median == 3);
  CHECK(odd.min == 1);
  CHECK(odd.max == 8);
  CHECK(odd.rmse == Approx(std::sqrt(74.0 / 3)));
  CHECK(statistics({4, 1, 2, 3}).median == 2.5);
  CHECK(statistics({}).count == 0);
}

TEST_CASE("path length adds the steps") {
  CHECK(pathLength(test::straightPath(11, 0.5)) == Approx(5));
  CHECK(pathLength(test::straightPath(1)) == 0);
  CHECK(pathLength({}) == 0);
}

TEST_CASE("a step that is 1 percent long costs 1 cm a metre, wherever the world lies") {
  RandomStream random(5);
  const Trajectory truth = test::straightPath(50, 2);
  const Trajectory estimate = test::moved(test::straightPath(50, 2.02), test::randomPose(random));
  const Matches matches = test::paired(truth, estimate);
  const RelativeError frames = relativeErrorOverFrames(matches);
  CHECK(frames.translation_m.count == 49);
  CHECK(frames.translation_m.rmse == Approx(0.02));
  CHECK(frames.rotation_deg.max < 1e-5);
  CHECK(relativeErrorOverFrames(matches, 10).translation_m.mean == Approx(0.2));
  const RelativeError metres = relativeErrorOverDistance(matches);
  CHECK(metres.translation_m.count == 49);
  CHECK(metres.translation_m.max == Approx(0.01));
}

TEST_CASE("a turning rate that is wrong shows as rotation error") {
  const Trajectory truth = test::straightPath(20);
  Trajectory estimate = truth;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  const double degree = std::numbers::pi / 180;
  for (auto& pose : estimate) {
    pose.T_world_camera = T;
    T = T * fromPlanar({1, 0, 0.5 * degree});
  }
  const RelativeError error = relativeErrorOverFrames(test::paired(truth, estimate));
  CHECK(error.rotation_deg.mean == Approx(0.5));
  CHECK(error.rotation_deg.min == Approx(0.5));
  CHECK(error.translation_m.max < 1e-12);
}

TEST_CASE("missing frames give no pairs over one frame") {
  const Trajectory truth = test::straightPath(10);
  Trajectory estimate = truth;
  estimate.erase(estimate.begin() + 4);
  const Matches matches = test::paired(truth, estimate);
  CHECK(relativeErrorOverFrames(matches).translation_m.count == 7);  // not 3-4, 4-5
  CHECK(relativeErrorOverFrames(matches, 2).translation_m.count == 6);
}

TEST_CASE("relative errors of single poses are empty, not wrong") {
  const Matches matches = test::paired(test::straightPath(1), test::straightPath(1));
  CHECK(relativeErrorOverFrames(matches).translation_m.count == 0);
  CHECK(relativeErrorOverDistance(matches).translation_m.count == 0);
  CHECK(absoluteError(matches).count == 1);
}

TEST_CASE("the step from one session to the next counts in no error") {
  // Two sessions of 60 m; between them the robot is carried 500 m, which the estimate has wrong.
  Trajectory truth = test::straightPath(120);
  Trajectory estimate = truth;
  for (std::size_t i = 60; i < truth.size(); ++i) {
    truth[i].T_world_camera.translation().x() += 500;
    estimate[i].T_world_camera.translation().x() += 490;
    truth[i].session = estimate[i].session = 1;
  }
  CHECK(pathLength(truth) == Approx(118));
  const Matches matches = test::paired(truth, estimate);
  const RelativeError frames = relativeErrorOverFrames(matches);
  CHECK(frames.translation_m.count == 118);
  CHECK(frames.translation_m.max < 1e-9);
  CHECK(relativeErrorOverDistance(matches, 5).translation_m.max < 1e-9);
  const SegmentErrors segments = segmentErrors(matches, {"custom", {20}});
  CHECK(segments.segments == 8);          // from 0, 10, 20, 30, and 60 to 90
  CHECK(segments.segments_in_gaps == 2);  // from 40 and 50
  CHECK(segments.t_rel_percent < 1e-9);
}

TEST_CASE("sub-paths over a bent way without true poses are left out, straight ones are not") {
  // A circle of 100 m, of which the truth lacks the frames 30 to 70.
  Trajectory estimate = test::straightPath(100);
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / 100;
    estimate[i].T_world_camera =
        fromPlanar({16 * std::sin(angle), 16 - 16 * std::cos(angle), angle});
  }
  Trajectory truth = estimate;
  truth.erase(truth.begin() + 30, truth.begin() + 70);
  const Matches bent = test::paired(truth, estimate);
  CHECK(bent.piece.back() == 1);
  const SegmentErrors segments = segmentErrors(bent, {"custom", {10}});
  CHECK(segments.segments_in_gaps > 0);
  CHECK(segments.t_rel_percent < 1e-9);
  CHECK(relativeErrorOverDistance(bent, 5).translation_m.max < 1e-9);
  Trajectory sparse = test::straightPath(100);
  const Trajectory straight = sparse;
  sparse.erase(sparse.begin() + 30, sparse.begin() + 70);
  CHECK(test::paired(sparse, straight).piece.back() == 0);
}
