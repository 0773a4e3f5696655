// SPDX-License-Identifier: BSD-3-Clause
// A motion over frames at which odometry failed: their predicted motions do not count twice.
#include "pipeline/predicted_way.hpp"

#include <catch2/catch.hpp>

using namespace tolman;
using pipeline::PredictedWay;

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

Motion taken(PredictedWay& way, Motion motion) {
  way.takeOut(motion);
  return motion;
}

}  // namespace

TEST_CASE("predictions and the motion that spans them are together what odometry measured") {
  PredictedWay way;
  taken(way, motionTo(0, 0, 0));
  taken(way, motionTo(1, 1, 0.1));
  Eigen::Isometry3d T_1_now = Eigen::Isometry3d::Identity();
  for (int frame = 2; frame < 5; ++frame) {
    const Motion predicted = motionTo(frame, 1, 0.1, 0.05);
    way.add(predicted);
    T_1_now = T_1_now * predicted.T_previous_current;
  }
  const Motion answer = motionTo(5, 3.2, 0.4, 0.3);
  const Motion motion = taken(way, answer);
  CHECK((T_1_now * motion.T_previous_current).isApprox(answer.T_previous_current, 1e-12));
  CHECK(motion.dt == Approx(0.1));

  MotionRevision revision{5, fromPlanar({3.3, 0.1, 0.31}), Matrix6d::Identity()};
  const Eigen::Isometry3d revised = revision.T_previous_current;
  way.takeOut(revision);
  CHECK((T_1_now * revision.T_previous_current).isApprox(revised, 1e-12));

  const Motion next = motionTo(6, 0.9, 0.1);
  CHECK(taken(way, next).T_previous_current.isApprox(next.T_previous_current, 1e-12));
}

TEST_CASE("a motion from the frame that odometry failed at is taken as it is") {
  PredictedWay way;
  taken(way, motionTo(1, 1, 0.1));
  way.add(motionTo(2, 1, 0.1));
  const Motion answer = motionTo(3, 1.1, 0.1);
  CHECK(taken(way, answer).T_previous_current.isApprox(answer.T_previous_current, 1e-12));
  MotionRevision revision{3, fromPlanar({1.2, 0, 0}), Matrix6d::Identity()};
  way.takeOut(revision);
  CHECK(revision.T_previous_current.isApprox(fromPlanar({1.2, 0, 0}), 1e-12));
}

TEST_CASE("a new start spans nothing") {
  PredictedWay way;
  taken(way, motionTo(1, 1, 0.1));
  way.add(motionTo(2, 1, 0.1));
  Motion start = motionTo(3, 0, 0.2);
  start.state = TrackingState::Initialising;
  CHECK(taken(way, start).T_previous_current.isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  const Motion next = motionTo(4, 1, 0.1);
  CHECK(taken(way, next).T_previous_current.isApprox(next.T_previous_current, 1e-12));
}
