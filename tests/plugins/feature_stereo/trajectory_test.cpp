// SPDX-License-Identifier: BSD-3-Clause
// What is answered and what is revised when keyframes move.
#include "trajectory.hpp"

#include <catch2/catch.hpp>

using namespace tolman;
using namespace tolman::feature_stereo;

namespace {

Eigen::Isometry3d forward(double metres) {
  return Eigen::Isometry3d(Eigen::Translation3d(0, 0, metres));
}

/// Keyframes at frames 0 and 2, frames 0 to 3 a metre apart.
struct Case {
  Window window;
  Trajectory trajectory;

  Case() {
    window.addKeyframe({0, forward(0)});
    window.addKeyframe({2, forward(2)});
    for (int k = 0; k < 4; ++k) {
      trajectory.add(k, forward(k), window.keyframes()[k < 2 ? 0 : 1], Matrix6d::Identity());
    }
  }
};

}  // namespace

TEST_CASE("a motion is the step from the frame before") {
  Case c;
  const Eigen::Isometry3d motion =
      c.trajectory.add(4, forward(4.5), c.window.keyframes()[1], Matrix6d::Identity());
  CHECK(motion.isApprox(forward(1.5)));
  CHECK(c.trajectory.revisions().empty());
}

TEST_CASE("frames follow their keyframe, and only the motion between keyframes is revised") {
  Case c;
  c.window.keyframes()[1].T_world_camera = forward(2.1);
  c.trajectory.follow(c.window);
  CHECK(c.trajectory.lastPose().isApprox(forward(3.1)));
  const auto revisions = c.trajectory.revisions();
  REQUIRE(revisions.size() == 1);
  CHECK(revisions[0].frame == 2);
  CHECK(revisions[0].T_previous_current.isApprox(forward(1.1)));
  CHECK(c.trajectory.revisions().empty());  // said once
}

TEST_CASE("small changes wait until the keyframe leaves the window") {
  Case c;
  c.window.keyframes()[1].T_world_camera = forward(2.0005);
  c.trajectory.follow(c.window);
  CHECK(c.trajectory.revisions().empty());
  CHECK(c.trajectory.retire(c.window).empty());  // no frame has left
  c.window.addKeyframe({5, forward(5)});
  c.window.dropOldest();
  c.window.dropOldest();
  const auto owed = c.trajectory.retire(c.window);
  REQUIRE(owed.size() == 1);
  CHECK(owed[0].frame == 2);
  CHECK(owed[0].T_previous_current.isApprox(forward(1.0005)));
  CHECK(c.trajectory.finish().empty());
}

TEST_CASE("finish tells what is owed") {
  Case c;
  c.window.keyframes()[1].T_world_camera = forward(2.0005);
  c.trajectory.follow(c.window);
  CHECK(c.trajectory.finish().size() == 1);
}

TEST_CASE("frames without sight are spread between the good ones") {
  Case c;  // frames 2 and 3 were predicted; in truth the camera had stopped halfway
  c.trajectory.bridge(2, forward(1.3));
  const auto revisions = c.trajectory.revisions();
  REQUIRE(revisions.size() == 2);
  CHECK(revisions[0].T_previous_current.isApprox(forward(0.1)));
  CHECK(revisions[1].T_previous_current.isApprox(forward(0.1)));
  const auto motion = c.trajectory.add(4, forward(1.3), c.window.keyframes()[1], Matrix6d::Zero());
  CHECK(motion.isApprox(forward(0.1)));
}

TEST_CASE("a camera that stands for long does not fill the memory") {
  Case c;
  const auto stands = static_cast<int>(Trajectory::kMost) + 50;
  for (int k = 4; k < stands; ++k) {
    c.trajectory.add(k, forward(3), c.window.keyframes()[1], Matrix6d::Identity());
  }
  c.window.keyframes()[1].T_world_camera = forward(3);
  c.trajectory.follow(c.window);
  CHECK(c.trajectory.lastPose().isApprox(forward(4)));
  CHECK(c.trajectory.revisions().empty());  // the step to the keyframe is long past
}
