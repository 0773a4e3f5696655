// SPDX-License-Identifier: BSD-3-Clause
#include "engine/path_check.hpp"

#include <catch2/catch.hpp>

using namespace tolman;
using namespace tolman::pipeline;

namespace {

Motion stepOf(std::int64_t frame, double length, TrackingState state = TrackingState::Tracking) {
  Motion motion;
  motion.frame = frame;
  motion.state = state;
  motion.T_previous_current.translation().z() = length;
  return motion;
}

/// Poses of frames 0, 1, 2, ... at these places.
std::vector<FramePose> posesAt(const std::vector<double>& places) {
  std::vector<FramePose> poses;
  for (const double z : places) {
    poses.push_back({std::ssize(poses), Eigen::Isometry3d::Identity()});
    poses.back().T_world_camera.translation().z() = z;
  }
  return poses;
}

/// Twenty frames, 1 m apart.
PathCheck drive(TrackingState of_tenth = TrackingState::Tracking) {
  PathCheck check;
  check.add(stepOf(0, 0, TrackingState::Initialising));
  for (int i = 1; i < 20; ++i) {
    check.add(stepOf(i, 1, i == 10 ? of_tenth : TrackingState::Tracking));
  }
  return check;
}

std::vector<double> places() {
  std::vector<double> all;
  for (int i = 0; i < 20; ++i) all.push_back(i);
  return all;
}

}  // namespace

TEST_CASE("a map that moves single frames away is told") {
  CHECK_FALSE(drive().contradiction(posesAt(places())));
  std::vector<double> apart = places();
  apart[9] += 50;
  const auto text = drive().contradiction(posesAt(apart));
  REQUIRE(text);
  CHECK_THAT(*text, Catch::StartsWith("the final poses of the tracked frames make a path of 117 m, "
                                      "and odometry 19 m: poseOf() moves frames apart"));
}

TEST_CASE(
    "a correction, a jump where tracking was lost, and noise of a robot that stands are not") {
  std::vector<double> corrected = places();  // by all of the path, in one step
  for (std::size_t i = 10; i < corrected.size(); ++i) corrected[i] += 19;
  CHECK_FALSE(drive().contradiction(posesAt(corrected)));
  for (std::size_t i = 10; i < corrected.size(); ++i) corrected[i] += 500;
  CHECK(drive().contradiction(posesAt(corrected)));
  CHECK_FALSE(drive(TrackingState::Lost).contradiction(posesAt(corrected)));
  CHECK_FALSE(drive(TrackingState::Initialising).contradiction(posesAt(corrected)));
  PathCheck still;
  for (int i = 0; i < 20; ++i) still.add(stepOf(i, 0));
  std::vector<double> noise(20, 0);
  for (std::size_t i = 0; i < noise.size(); i += 2) noise[i] = 0.05;
  CHECK_FALSE(still.contradiction(posesAt(noise)));
}

TEST_CASE("steps over frames without a pose are left out") {
  std::vector<FramePose> poses = posesAt(places());
  poses[5].T_world_camera.translation().z() += 500;
  CHECK(drive().contradiction(poses));
  poses.erase(poses.begin() + 6);
  poses.erase(poses.begin() + 4);  // frame 5 alone
  CHECK_FALSE(drive().contradiction(poses));
  CHECK_FALSE(drive().contradiction({}));
}
