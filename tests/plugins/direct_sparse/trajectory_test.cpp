// SPDX-License-Identifier: BSD-3-Clause
// What is answered and what is revised when keyframes move.
#include "trajectory.hpp"

#include <catch2/catch.hpp>

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

Eigen::Isometry3d forward(double metres) {
  return Eigen::Isometry3d(Eigen::Translation3d(0, 0, metres));
}

/// Keyframes at frames 0 and 2, frames 0 to 3 a metre apart.
struct Case {
  Window window;
  Trajectory trajectory;

  Case() {
    add(0, 0);
    add(2, 2);
    for (int k = 0; k < 4; ++k) {
      trajectory.add(k, forward(k), window.keyframe(k < 2 ? 0 : 1), Matrix6d::Identity());
    }
  }
  void add(std::int64_t frame, double metres) {
    Keyframe& keyframe = window.add();
    keyframe.frame = frame;
    keyframe.T0_camera_world = forward(metres).inverse();
  }
  void moveSecond(double metres) { window.keyframe(1).T0_camera_world = forward(metres).inverse(); }
};

}  // namespace

TEST_CASE("a motion is the step from the frame before") {
  Case c;
  const Eigen::Isometry3d motion =
      c.trajectory.add(4, forward(4.5), c.window.keyframe(1), Matrix6d::Identity());
  CHECK(motion.isApprox(forward(1.5)));
  CHECK(c.trajectory.revisions().empty());
}

TEST_CASE("frames follow their keyframe, and only the motion between keyframes is revised") {
  Case c;
  c.moveSecond(2.1);
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
  c.moveSecond(2.0005);
  c.trajectory.follow(c.window);
  CHECK(c.trajectory.revisions().empty());
  CHECK(c.trajectory.retire(c.window).empty());  // no frame has left
  c.add(5, 5);
  c.window.remove(0);
  c.window.remove(1);
  const auto owed = c.trajectory.retire(c.window);
  REQUIRE(owed.size() == 1);
  CHECK(owed[0].frame == 2);
  CHECK(owed[0].T_previous_current.isApprox(forward(1.0005)));
  CHECK(c.trajectory.finish().empty());
}

TEST_CASE("finish tells what is owed") {
  Case c;
  c.moveSecond(2.0005);
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
  const auto motion = c.trajectory.add(4, forward(1.3), c.window.keyframe(1), Matrix6d::Zero());
  CHECK(motion.isApprox(forward(0.1)));
}

TEST_CASE("a camera that stands for long does not fill the memory") {
  Case c;
  const auto stands = static_cast<int>(Trajectory::kMost) + 50;
  for (int k = 4; k < stands; ++k) {
    c.trajectory.add(k, forward(3), c.window.keyframe(1), Matrix6d::Identity());
  }
  c.moveSecond(3);
  c.trajectory.follow(c.window);
  CHECK(c.trajectory.lastPose().isApprox(forward(4)));
  CHECK(c.trajectory.revisions().empty());  // the step to the keyframe is long past
}

TEST_CASE("a motion that was answered as nothing is owed in full") {
  Case c;
  c.trajectory.add(4, forward(4), c.window.keyframe(1), Matrix6d::Identity());
  c.trajectory.answeredNothing();
  const auto revisions = c.trajectory.revisions();
  REQUIRE(revisions.size() == 1);
  CHECK(revisions[0].frame == 4);
  CHECK(revisions[0].T_previous_current.isApprox(forward(1)));
}

TEST_CASE("slots of the window are used again, residuals to a removed keyframe forgotten") {
  Case c;
  Point point;
  point.temporal[0] = ResidualState::Good;
  c.window.keyframe(1).points.push_back(point);
  c.window.remove(0);
  CHECK(c.window.keyframe(1).points[0].temporal[0] == ResidualState::Absent);
  CHECK(c.window.find(0) == nullptr);
  REQUIRE(c.window.find(2) != nullptr);
  c.add(7, 7);
  CHECK(c.window.newestSlot() == 0);
  CHECK(c.window.find(7) == &c.window.keyframe(0));
  CHECK(c.window.pointCount() == 1);
  c.window.clear();
  CHECK(c.window.empty());
}
