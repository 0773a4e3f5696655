// SPDX-License-Identifier: BSD-3-Clause
// Reported and revised motions when keyframes move.
#include <catch2/catch.hpp>
#include <map>
#include <optional>

#include "tolman/records.hpp"

using namespace tolman;

namespace {

Eigen::Isometry3d forward(double metres) {
  return Eigen::Isometry3d(Eigen::Translation3d(0, 0, metres));
}

/// Keyframes at frames 0 and 2, frames 0 to 3 a metre apart.
struct Case {
  std::map<std::int64_t, double> keyframes{{0, 0}, {2, 2}};  ///< metres forward, by frame
  MotionHistory<> history;

  Case() {
    for (int k = 0; k < 4; ++k) add(k, k, k < 2 ? 0 : 2);
  }
  Eigen::Isometry3d add(std::int64_t frame, double metres, std::int64_t keyframe = 2,
                        double dt = 1) {
    return history.add(frame, forward(metres), keyframe, forward(keyframes[keyframe]).inverse(),
                       Matrix6d::Identity(), dt);
  }
  std::optional<Eigen::Isometry3d> operator()(std::int64_t keyframe) const {
    const auto found = keyframes.find(keyframe);
    if (found == keyframes.end()) return std::nullopt;
    return forward(found->second);
  }
  void moveSecond(double metres) {
    keyframes[2] = metres;
    history.followKeyframes(*this);
  }
};

}  // namespace

TEST_CASE("a motion is the step from the frame before") {
  Case c;
  CHECK(c.add(4, 4.5).isApprox(forward(1.5)));
  CHECK(c.history.largeRevisions().empty());
}

TEST_CASE("frames follow their keyframe, and only the motion between keyframes is revised") {
  Case c;
  c.moveSecond(2.1);
  CHECK(c.history.lastPose().isApprox(forward(3.1)));
  const auto revisions = c.history.largeRevisions();
  REQUIRE(revisions.size() == 1);
  CHECK(revisions[0].frame == 2);
  CHECK(revisions[0].T_previous_current.isApprox(forward(1.1)));
  CHECK(c.history.largeRevisions().empty());  // handed out once
}

TEST_CASE("small changes wait until the keyframe leaves the window") {
  Case c;
  c.moveSecond(2.0005);
  CHECK(c.history.largeRevisions().empty());
  CHECK(c.history.removeOld(c).empty());  // no frame has left
  c.keyframes = {{5, 5}};
  const auto revisions = c.history.removeOld(c);
  REQUIRE(revisions.size() == 1);
  CHECK(revisions[0].frame == 2);
  CHECK(revisions[0].T_previous_current.isApprox(forward(1.0005)));
  CHECK(c.history.finish().empty());
}

TEST_CASE("after old frames are removed, the next motion still starts at the last of them") {
  Case c;
  c.keyframes = {{4, 4}};
  c.history.removeOld(c);
  CHECK(c.history.lastPose().isApprox(forward(3)));
  CHECK(c.add(4, 4.25, 4).isApprox(forward(1.25)));
}

TEST_CASE("small changes are handed out at the end") {
  Case c;
  c.moveSecond(2.0005);
  CHECK(c.history.finish().size() == 1);
}

TEST_CASE("frames without measurement are interpolated between measured ones") {
  Case c;  // frames 2 and 3 were predicted; in truth the camera had stopped halfway
  c.history.interpolate(2, forward(1.3));
  const auto revisions = c.history.largeRevisions();
  REQUIRE(revisions.size() == 2);
  CHECK(revisions[0].T_previous_current.isApprox(forward(0.1)));
  CHECK(revisions[1].T_previous_current.isApprox(forward(0.1)));
  CHECK(c.add(4, 1.3).isApprox(forward(0.1)));
}

TEST_CASE("a frame without an image between interpolated frames leaves a longer step") {
  Case c;
  c.add(4, 4, 2, 0.1);  // predicted; the next image is missing
  c.history.interpolate(4, forward(5.1), 0.2);
  const auto revisions = c.history.largeRevisions();
  REQUIRE(revisions.size() == 1);
  CHECK(revisions[0].frame == 4);
  CHECK(revisions[0].T_previous_current.isApprox(forward(0.7)));  // 2.1 m in 0.3 s
  CHECK(c.add(5, 5.1, 2, 0.2).isApprox(forward(1.4)));
}

TEST_CASE("where no time passes, interpolated steps are equal") {
  Case c;
  c.add(4, 4, 2, 0);
  c.history.interpolate(4, forward(5), 0);
  CHECK(c.add(5, 5, 2, 0).isApprox(forward(1)));
}

TEST_CASE("a camera that stands for long does not fill the memory") {
  Case c;
  const auto frames = static_cast<int>(MotionHistory<>::kMaxFrames) + 50;
  for (int k = 4; k < frames; ++k) c.add(k, 3);
  c.moveSecond(3);
  CHECK(c.history.lastPose().isApprox(forward(4)));
  CHECK(c.history.largeRevisions().empty());  // the step to the keyframe has been removed
}

TEST_CASE("a motion that was reported as the identity is revised in full") {
  Case c;
  c.add(4, 4);
  c.history.setLastReportedIdentity();
  const auto revisions = c.history.largeRevisions();
  REQUIRE(revisions.size() == 1);
  CHECK(revisions[0].frame == 4);
  CHECK(revisions[0].T_previous_current.isApprox(forward(1)));
}

TEST_CASE("a prediction is the less certain the longer nothing was measured") {
  const Matrix6d first = predictionCovariance(forward(1), 1);
  CHECK(std::sqrt(first(2, 2)) == Approx(0.4));  // 0.1 m and 30 % of a metre
  CHECK(std::sqrt(first(4, 4)) == Approx(0.03));
  CHECK(predictionCovariance(forward(1), 3).isApprox(9 * first));
}
