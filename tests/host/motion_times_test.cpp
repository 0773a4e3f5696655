// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "host/frame_at.hpp"
#include "host/stages.hpp"

using namespace tolman;
using namespace tolman::host;
using tolman::test::frameAt;

namespace {

bool allows(const MotionTimes& times, std::int64_t frame, double dt,
            TrackingState state = TrackingState::Tracking) {
  Motion motion;
  motion.state = state;
  motion.dt = dt;
  return times.check(frameAt(frame), motion).isOk();
}

}  // namespace

TEST_CASE("dt is about the time since the frame before") {
  MotionTimes times;
  CHECK(allows(times, 0, 0));
  times.add(frameAt(0), true);
  CHECK(allows(times, 1, 0.1));
  CHECK(allows(times, 1, 0.04));  // a nominal rate
  CHECK_FALSE(allows(times, 1, 0));
  CHECK_FALSE(allows(times, 1, -0.1));
  CHECK_FALSE(allows(times, 1, 100));
  Motion motion;
  motion.dt = -3;
  CHECK(times.check(frameAt(1), motion).message() == "'dt' is -3 s");
  motion.dt = 1e9;
  CHECK(times.check(frameAt(1), motion).message() ==
        "'dt' is 1e+09 s, the stamps say 0.1 s; see setPlanarVelocity()");
}

TEST_CASE("after a failure it may count from the last answer, and a new process from 0") {
  MotionTimes times;
  times.add(frameAt(0), true);
  for (std::int64_t k = 1; k < 30; ++k) times.add(frameAt(k), false);
  CHECK(allows(times, 30, 0.1));
  CHECK(allows(times, 30, 3));
  CHECK(allows(times, 30, 0, TrackingState::Initialising));
  CHECK_FALSE(allows(times, 30, 0));
  CHECK_FALSE(allows(times, 30, 100, TrackingState::Initialising));
}

TEST_CASE("the last frame is known") {
  MotionTimes times;
  CHECK(times.lastFrame() == INT64_MAX);
  times.add(frameAt(3), true);
  CHECK(times.lastFrame() == 3);
}
