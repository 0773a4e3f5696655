// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/kitti_segments.hpp"

#include <catch2/catch.hpp>

#include "evaluation/paths.hpp"

using namespace tolman;
using namespace tolman::evaluation;

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
