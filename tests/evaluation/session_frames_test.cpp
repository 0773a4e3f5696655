// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/session_frames.hpp"

#include <catch2/catch.hpp>

#include "evaluation/metrics.hpp"
#include "evaluation/paths.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

/// A drive with bends on level ground, in two sessions of 150 poses.
Trajectory twoSessions() {
  Trajectory path = test::straightPath(300);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (TrajectoryPose& pose : path) {
    pose.T_world_camera = T;
    if (pose.frame >= 150) pose.session = 1;
    const double turn = 0.05 * std::sin(0.03 * static_cast<double>(pose.frame));
    T = T * Eigen::Translation3d(0, 0, 1) * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY());
  }
  return path;
}

/// The second session as seen from its own first pose, as sources give the truth.
Trajectory fromOwnFirst(Trajectory path) {
  const Eigen::Isometry3d T_first_world = path[150].T_world_camera.inverse();
  for (TrajectoryPose& pose : path) {
    if (pose.session == 1) pose.T_world_camera = T_first_world * pose.T_world_camera;
  }
  return path;
}

Trajectory withNoise(Trajectory path, double metres) {
  RandomStream random(6);
  for (TrajectoryPose& pose : path) {
    pose.T_world_camera.translation() +=
        metres * Eigen::Vector3d(random.normal(), 0, random.normal());
  }
  return path;
}

Trajectory ofOneSession(Trajectory path) {
  for (TrajectoryPose& pose : path) pose.session = 0;
  return path;
}

}  // namespace

TEST_CASE("true poses that each session counts from its own first frame are detected") {
  const Trajectory estimate = withNoise(twoSessions(), 0.3);
  const Trajectory truth = fromOwnFirst(twoSessions());
  const auto alignment = GENERATE(Alignment::None, Alignment::Se2, Alignment::Se3, Alignment::Sim3);
  const TrajectoryMetrics metrics = scoreTrajectory(truth, estimate, alignment);
  INFO(metrics.warning);
  CHECK(metrics.warning.find("the true poses of the sessions are not in one frame") !=
        std::string::npos);
  CHECK(metrics.warning.find("truth_origin: data") != std::string::npos);
  CHECK(metrics.warning.find("joins the sessions at a wrong place") != std::string::npos);
  const bool units = metrics.warning.find("units of different lengths") != std::string::npos;
  CHECK(units == (alignment == Alignment::Sim3));
}

TEST_CASE("truth in one frame gives no hint, whether the map is good or poor") {
  const Trajectory truth = twoSessions();
  const auto hint = [&](const Trajectory& estimate) {
    return sessionFramesHint(test::paired(truth, estimate), Alignment::Se2);
  };
  CHECK(hint(truth).empty());
  CHECK(hint(withNoise(truth, 0.3)).empty());
  CHECK(hint(withNoise(truth, 20)).empty());
  Trajectory joined_askew = truth;  // the second session by 2 m, as after a poor loop
  for (TrajectoryPose& pose : joined_askew) {
    if (pose.session == 1) pose.T_world_camera.translation().x() += 2;
  }
  CHECK(hint(joined_askew).empty());
}

TEST_CASE("poses of one session are not compared with each other") {
  const Matches one = test::paired(ofOneSession(fromOwnFirst(twoSessions())), twoSessions());
  CHECK(sessionFramesHint(one, Alignment::Se3).empty());
}
