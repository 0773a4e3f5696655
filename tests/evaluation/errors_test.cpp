// SPDX-License-Identifier: BSD-3-Clause
// Absolute and relative errors, drift, and the consistency of covariances.
#include "evaluation/errors.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "evaluation/paths.hpp"
#include "tolman/context.hpp"
#include "tolman/geometry.hpp"

using namespace tolman::evaluation;
using namespace tolman;

namespace {

constexpr std::int64_t kMotions = 4000;
constexpr Steps kPerMetre{.unit = StepUnit::Metres, .divided = true};

/// Different in each direction, with position and heading correlated.
Matrix6d claimed() {
  Vector6d sigma;
  sigma << 0.02, 0.01, 0.05, 0.002, 0.004, 0.001;
  Matrix6d covariance = sigma.array().square().matrix().asDiagonal();
  covariance(0, 4) = covariance(4, 0) = 0.6 * sigma[0] * sigma[4];
  return covariance;
}

/// Motions along a curve whose errors are drawn from `claimed()`, times `exaggeration`.
struct Drive {
  Trajectory truth;
  std::vector<Motion> motions;

  explicit Drive(double exaggeration) {
    RandomStream random(5);
    const Matrix6d root = claimed().llt().matrixL();
    Vector6d twist;
    twist << 0, 0, 1, 0, 0.03, 0;
    const Eigen::Isometry3d step = expSe3(twist);
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    for (std::int64_t i = 0; i <= kMotions; ++i) {
      truth.push_back({i, i, T});
      T = T * step;
      Motion motion;
      motion.frame = i;
      motion.state = i == 0 ? TrackingState::Initialising : TrackingState::Tracking;
      motion.covariance = claimed();
      Vector6d draw;
      for (double& x : draw) x = random.normal();
      motion.T_previous_current = step * expSe3(Vector6d(exaggeration * (root * draw))).inverse();
      motions.push_back(motion);
    }
  }
  MotionConsistency measured(bool planar = false) const {
    MotionErrors errors(truth, planar);
    for (const Motion& motion : motions) errors.add(motion);
    return errors.result();
  }
};

}  // namespace

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
  const RelativeError frames = relativeError(matches, {});
  CHECK(frames.translation_m.count == 49);
  CHECK(frames.translation_m.rmse == Approx(0.02));
  CHECK(frames.rotation_deg.max < 1e-5);
  CHECK(relativeError(matches, {10}).translation_m.mean == Approx(0.2));
  const RelativeError metres = relativeError(matches, kPerMetre);
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
  const RelativeError error = relativeError(test::paired(truth, estimate), {});
  CHECK(error.rotation_deg.mean == Approx(0.5));
  CHECK(error.rotation_deg.min == Approx(0.5));
  CHECK(error.translation_m.max < 1e-12);
}

TEST_CASE("missing frames give no pairs over one frame") {
  const Trajectory truth = test::straightPath(10);
  Trajectory estimate = truth;
  estimate.erase(estimate.begin() + 4);
  const Matches matches = test::paired(truth, estimate);
  CHECK(relativeError(matches, {}).translation_m.count == 7);  // not 3-4, 4-5
  CHECK(relativeError(matches, {2}).translation_m.count == 6);
}

TEST_CASE("relative errors of single poses are empty, not wrong") {
  const Matches matches = test::paired(test::straightPath(1), test::straightPath(1));
  CHECK(relativeError(matches, {}).translation_m.count == 0);
  CHECK(relativeError(matches, kPerMetre).translation_m.count == 0);
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
  const RelativeError frames = relativeError(matches, {});
  CHECK(frames.translation_m.count == 118);
  CHECK(frames.translation_m.max < 1e-9);
  CHECK(relativeError(matches, {5, StepUnit::Metres}).translation_m.max < 1e-9);
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
  CHECK(relativeError(bent, {5, StepUnit::Metres}).translation_m.max < 1e-9);
  Trajectory sparse = test::straightPath(100);
  const Trajectory straight = sparse;
  sparse.erase(sparse.begin() + 30, sparse.begin() + 70);
  CHECK(test::paired(sparse, straight).piece.back() == 0);
}

TEST_CASE("segments by hand: 2 percent too long on a straight of 1 m steps") {
  // Truth: 0 ... 350 m. A segment of length L ends at the first pose more than L away, so it spans
  // L + 1 steps, and its error is 0.02 (L + 1) m. Starts 0, 10, ... must have start + L + 1 <= 350.
  const Trajectory truth = test::straightPath(351);
  const Trajectory estimate = test::straightPath(351, 1.02);
  const SegmentErrors errors = segmentErrors(test::paired(truth, estimate), kittiLengths());
  // 100 m: starts 0 ... 240 = 25; 200 m: 0 ... 140 = 15; 300 m: 0 ... 40 = 5.
  CHECK(errors.segments == 45);
  const double sum = 25 * 0.02 * 101 / 100 + 15 * 0.02 * 201 / 200 + 5 * 0.02 * 301 / 300;
  CHECK(errors.t_rel_percent == Approx(100 * sum / 45));
  CHECK(errors.r_rel_deg_per_100m == Approx(0).margin(1e-6));
}

TEST_CASE("segments by hand: a steady wrong turn") {
  // Each step of 1 m turns by 0.01 deg too much: a segment of L turns 0.01 (L + 1) deg wrong.
  const Trajectory truth = test::straightPath(112);
  Trajectory estimate = truth;
  const double step = 0.01 * std::numbers::pi / 180;
  for (auto& pose : estimate) {
    pose.T_world_camera.linear() =
        fromPlanar({0, 0, step * static_cast<double>(pose.frame)}).linear();
  }
  const SegmentErrors errors = segmentErrors(test::paired(truth, estimate), kittiLengths());
  CHECK(errors.segments == 2);  // starts 0 and 10
  CHECK(errors.r_rel_deg_per_100m == Approx(0.01 * 101));
}

TEST_CASE("segment errors do not depend on where the worlds lie") {
  RandomStream random(8);
  const Trajectory truth = test::wanderingPath(120, random);
  const Trajectory estimate = test::wanderingPath(120, random);
  const SegmentErrors one = segmentErrors(test::paired(truth, estimate), shortLengths());
  const SegmentErrors two =
      segmentErrors(test::paired(test::moved(truth, test::randomPose(random)),
                                 test::moved(estimate, test::randomPose(random))),
                    shortLengths());
  CHECK(one.segments > 20);
  CHECK(one.segments == two.segments);
  CHECK(one.t_rel_percent == Approx(two.t_rel_percent));
  CHECK(one.r_rel_deg_per_100m == Approx(two.r_rel_deg_per_100m));
}

TEST_CASE("gaps do not raise the drift: 1 percent too long, with poses missing") {
  const Trajectory truth = test::straightPath(400);
  const Trajectory whole = test::straightPath(400, 1.01);
  Trajectory gap = whole;
  gap.erase(gap.begin() + 100, gap.begin() + 300);
  const SegmentErrors one_gap = segmentErrors(test::paired(truth, gap), kittiLengths());
  CHECK(one_gap.segments > 0);
  CHECK(one_gap.segments_in_gaps > 0);
  CHECK(one_gap.t_rel_percent == Approx(1.01).margin(0.02));

  Trajectory sparse;  // steps of 7 m: no segment ends at the first true pose beyond its length
  for (std::size_t i = 0; i < whole.size(); i += 7) sparse.push_back(whole[i]);
  const SegmentErrors steps = segmentErrors(test::paired(truth, sparse), kittiLengths());
  CHECK(steps.segments > 0);
  CHECK(steps.segments_in_gaps == 0);
  CHECK(steps.t_rel_percent == Approx(1).margin(1e-9));
}

TEST_CASE("the way through a gap is that of the whole truth") {
  // Out and back over 150 m each, and on; the estimate lacks the turn. The chord of the gap is
  // short.
  Trajectory truth = test::straightPath(500);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double s = static_cast<double>(i);
    const double x = s < 150 ? s : s < 300 ? 300 - s : s - 300;
    truth[i].T_world_camera.translation() = Eigen::Vector3d(0, 0, x);
  }
  Trajectory estimate = truth;
  for (auto& pose : estimate) pose.T_world_camera.translation() *= 1.01;
  estimate.erase(estimate.begin() + 100, estimate.begin() + 200);
  const Matches matches = test::paired(truth, estimate);
  CHECK(matches.driven[100] - matches.driven[99] == Approx(101));
  CHECK(segmentErrors(matches, kittiLengths()).segments_in_gaps > 0);
  CHECK(segmentErrors(matches, kittiLengths()).t_rel_percent < 1.03);
}

TEST_CASE("segments far shorter than the way between two frames are left out") {
  const Trajectory truth = test::straightPath(41);
  const Trajectory estimate = test::straightPath(41, 1.02);
  const SegmentErrors errors = segmentErrors(test::paired(truth, estimate), {"custom", {0.1, 4}});
  CHECK(errors.segments == 4);  // starts 0, 10, 20 and 30; a segment of 4 m spans 5 steps
  CHECK(errors.segments_in_gaps == 4);
  CHECK(errors.t_rel_percent == Approx(2 * 5.0 / 4));
}

TEST_CASE("short paths have their own, named lengths") {
  CHECK(lengthsFor(4000).name == "kitti");
  CHECK(lengthsFor(60).name == "short");
  CHECK(lengthsFor(60).lengths_m.back() == 50);
  const SegmentErrors none =
      segmentErrors(test::paired(test::straightPath(3), test::straightPath(3)), shortLengths());
  CHECK(none.segments == 0);
}

TEST_CASE("Errors that fit their covariance have the degrees of freedom as mean") {
  const Drive drive(1);
  const MotionConsistency all = drive.measured();
  CHECK(all.motions == kMotions);
  CHECK(all.degrees_of_freedom == 6);
  CHECK(all.mean == Approx(6).epsilon(0.05));
  CHECK(all.share_99 == Approx(0.99).margin(0.006));
  const MotionConsistency planar = drive.measured(true);
  CHECK(planar.degrees_of_freedom == 3);
  CHECK(planar.mean == Approx(3).epsilon(0.05));
  CHECK(planar.share_99 == Approx(0.99).margin(0.006));
}

TEST_CASE("Errors twice as large as their covariance give four times the mean") {
  const MotionConsistency twice = Drive(2).measured();
  CHECK(twice.mean == Approx(24).epsilon(0.05));
  CHECK(twice.share_99 < 0.7);
}

TEST_CASE("Motions that are lost, without scale, or without truth at an end are left out") {
  Drive drive(1);
  drive.motions[10].state = TrackingState::Lost;
  drive.motions[20].scale_known = false;
  drive.truth.erase(drive.truth.begin() + 30);  // both motions that end there
  CHECK(drive.measured().motions == kMotions - 4);
  drive.truth.clear();
  const auto json = toJson(drive.measured());
  CHECK(json["mean"].is_null());
  CHECK(json["share_within_99"].is_null());
  CHECK(json["reason"].is_string());
}

TEST_CASE("A covariance of zero is counted, not divided by") {
  Drive drive(1);
  for (Motion& motion : drive.motions) motion.covariance.setZero();
  const MotionConsistency none = drive.measured();
  CHECK(none.without_covariance == kMotions);
  CHECK(none.share_99 == 0);
  CHECK(toJson(none)["mean"].is_null());
}
