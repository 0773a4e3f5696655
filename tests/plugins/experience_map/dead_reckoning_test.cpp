// SPDX-License-Identifier: BSD-3-Clause
// Dead reckoning, its revision, and the covariance of a motion over several frames.
#include "dead_reckoning.hpp"

#include "map_fixture.hpp"

namespace tolman::experience_map {
namespace {

Motion motionTo(std::int64_t frame, const Eigen::Isometry3d& T) {
  Motion motion;
  motion.frame = frame;
  motion.stamp_ns = frame * 100'000'000;
  motion.state = TrackingState::Tracking;
  motion.T_previous_current = T;
  motion.covariance = isotropic(0.1, 0.01);
  return motion;
}

DeadReckoning drive(std::int64_t frames, std::int64_t stride = 1) {
  DeadReckoning path;
  for (std::int64_t k = 0; k < frames; ++k) path.append(motionTo(k * stride, step(1, 0.1)), 0);
  return path;
}

}  // namespace

TEST_CASE("frames that were left out have no slot") {
  const DeadReckoning path = drive(5, 3);
  CHECK(path.slotOf(9) == 3);
  CHECK(path.slotOf(0) == 0);
  CHECK_FALSE(path.slotOf(10));
  CHECK_FALSE(path.slotOf(13));
  CHECK_FALSE(path.slotOf(-1));
  CHECK(path.seconds(1, 4) == Approx(0.9));
}

TEST_CASE("the first motion arrives at the origin, whatever it says") {
  const DeadReckoning path = drive(2);
  CHECK(difference(path[0].T_start_camera, Eigen::Isometry3d::Identity()) == 0);
  CHECK(difference(path[1].T_start_camera, step(1, 0.1)) < 1e-15);
}

TEST_CASE("frames that do not come in order are refused") {
  const DeadReckoning path = drive(5);
  CHECK(path.check(motionTo(5, step(1))).isOk());
  CHECK(path.check(motionTo(4, step(1))).message() ==
        "motion of frame 4 comes after that of frame 4; frames must come in order");
}

TEST_CASE("a revision moves everything behind it and nothing before") {
  DeadReckoning path = drive(10);
  const DeadReckoning before = drive(10);
  std::size_t unknown = 0;
  MotionRevision first_try{
      .frame = 6, .T_previous_current = step(9, 9), .covariance = Matrix6d::Zero()};
  MotionRevision final_try{
      .frame = 6, .T_previous_current = step(2, 0), .covariance = Matrix6d::Zero()};
  MotionRevision of_nothing{
      .frame = 77, .T_previous_current = step(2), .covariance = Matrix6d::Zero()};
  const std::vector<MotionRevision> revisions = {first_try, of_nothing, final_try};
  CHECK(path.revise(revisions, unknown) == 6);
  CHECK(unknown == 1);
  CHECK(difference(path[5].T_start_camera, before[5].T_start_camera) == 0);
  CHECK(difference(path[6].T_start_camera, before[5].T_start_camera * step(2, 0)) < 1e-14);
  CHECK(difference(path.between(6, 9).T, before.between(6, 9).T) < 1e-14);
}

TEST_CASE("uncertainty of a way grows with its motions, and most where tracking was lost") {
  DeadReckoning sound = drive(3);
  DeadReckoning weak = drive(2);
  Motion lost = motionTo(2, step(1, 0.1));
  lost.state = TrackingState::Lost;
  weak.append(lost, 0);
  const Parameters defaults;
  const double sound_variance = sound.between(0, 2).covariance(2, 2);
  const double one_motion = sound.between(0, 1).covariance(2, 2);
  const double weak_variance = weak.between(0, 2).covariance(2, 2);
  CHECK(sound_variance > 2 * 0.01);
  CHECK(one_motion == Approx(0.01 + std::pow(defaults.drift_translation, 2)));
  CHECK(weak_variance - sound_variance ==
        Approx(std::pow(defaults.assumed_sigma_translation / 3, 2)));
}

}  // namespace tolman::experience_map
