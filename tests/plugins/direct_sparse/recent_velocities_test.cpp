// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "lost_motion.hpp"

using tolman::RecentVelocities;
using tolman::Vector6d;

TEST_CASE("one wrong velocity of the last three does not count") {
  RecentVelocities recent;
  CHECK(recent.median().isZero(0));
  Vector6d good;
  good << 0, 0, 12, 0, 0.1, 0;
  Vector6d wrong;
  wrong << 0.5, -0.8, 11, 0.2, -0.3, 0.1;
  recent.add(good);
  CHECK(recent.median() == good);
  recent.add(1.1 * good);
  CHECK(recent.median() == 1.1 * good);  // of two nobody knows which is wrong
  for (int i = 0; i < 4; ++i) {
    recent.add(good);
    recent.add(good);
    recent.add(wrong);
    CHECK(recent.median() == good);
  }
  recent.add(wrong);
  CHECK(recent.median() == wrong);
  recent.clear();
  CHECK(recent.median().isZero(0));
}

TEST_CASE("of three velocities each component has its own median") {
  RecentVelocities recent;
  for (const double value : {3.0, 1.0, 2.0}) {
    Vector6d velocity = Vector6d::Constant(value);
    velocity[5] = -value;
    recent.add(velocity);
  }
  CHECK(recent.median().head<5>() == Eigen::Matrix<double, 5, 1>::Constant(2));
  CHECK(recent.median()[5] == -2);
}
