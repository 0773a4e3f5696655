// SPDX-License-Identifier: BSD-3-Clause
// A motion over frames at which odometry failed: their predicted motions do not count twice.
#include <catch2/catch.hpp>

#include "engine/checked_odometry.hpp"

using namespace tolman;
using engine::PredictedSpan;

namespace {

Motion motionTo(std::int64_t frame, double metres, double dt, double turn = 0) {
  Motion motion;
  motion.frame = frame;
  motion.stamp_ns = frame * 100'000'000;
  motion.state = TrackingState::Tracking;
  motion.T_previous_current = fromPlanar({metres, 0, turn});
  setPlanarVelocity(motion, dt);
  return motion;
}

Motion remaining(PredictedSpan& span, Motion motion) {
  span.subtractFrom(motion);
  return motion;
}

}  // namespace

TEST_CASE("predictions and the remaining motion compose to the motion that odometry measured") {
  PredictedSpan span;
  remaining(span, motionTo(0, 0, 0));
  remaining(span, motionTo(1, 1, 0.1));
  Eigen::Isometry3d T_1_now = Eigen::Isometry3d::Identity();
  for (int frame = 2; frame < 5; ++frame) {
    const Motion predicted = motionTo(frame, 1, 0.1, 0.05);
    span.add(predicted);
    T_1_now = T_1_now * predicted.T_previous_current;
  }
  const Motion answer = motionTo(5, 3.2, 0.4, 0.3);
  const Motion motion = remaining(span, answer);
  CHECK((T_1_now * motion.T_previous_current).isApprox(answer.T_previous_current, 1e-12));
  CHECK(motion.dt == Approx(0.1));

  MotionRevision revision{5, fromPlanar({3.3, 0.1, 0.31}), Matrix6d::Identity()};
  const Eigen::Isometry3d revised = revision.T_previous_current;
  span.subtractFrom(revision);
  CHECK((T_1_now * revision.T_previous_current).isApprox(revised, 1e-12));

  const Motion next = motionTo(6, 0.9, 0.1);
  CHECK(remaining(span, next).T_previous_current.isApprox(next.T_previous_current, 1e-12));
}

TEST_CASE("a motion relative to the frame at which odometry failed is unchanged") {
  PredictedSpan span;
  remaining(span, motionTo(1, 1, 0.1));
  span.add(motionTo(2, 1, 0.1));
  const Motion answer = motionTo(3, 1.1, 0.1);
  CHECK(remaining(span, answer).T_previous_current.isApprox(answer.T_previous_current, 1e-12));
  MotionRevision revision{3, fromPlanar({1.2, 0, 0}), Matrix6d::Identity()};
  span.subtractFrom(revision);
  CHECK(revision.T_previous_current.isApprox(fromPlanar({1.2, 0, 0}), 1e-12));
}

TEST_CASE("a motion in state initialising is unchanged and ends the span") {
  PredictedSpan span;
  remaining(span, motionTo(1, 1, 0.1));
  span.add(motionTo(2, 1, 0.1));
  Motion start = motionTo(3, 0, 0.2);
  start.state = TrackingState::Initialising;
  CHECK(remaining(span, start).T_previous_current.isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  const Motion next = motionTo(4, 1, 0.1);
  CHECK(remaining(span, next).T_previous_current.isApprox(next.T_previous_current, 1e-12));
}
