// SPDX-License-Identifier: BSD-3-Clause
// Two trajectories of the same, wrong convention.
#include "evaluation/pose_reading.hpp"

#include <catch2/catch.hpp>

#include "evaluation/metrics.hpp"
#include "evaluation/paths.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

/// A car on a winding road, whose camera looks ahead (z); `sideways`: a camera that is carried, and
/// looks to the side and back on the way.
Trajectory drive(double noise_m, double sideways = 0, int poses = 400) {
  Trajectory path;
  RandomStream random(9);
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  for (int i = 0; i < poses; ++i) {
    const double angle = 0.03 * i + std::sin(0.05 * i);
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    at += Eigen::Vector3d(std::sin(angle), 0, std::cos(angle));
    T.linear() =
        Eigen::AngleAxisd(angle + sideways * 0.02 * i, Eigen::Vector3d::UnitY()).toRotationMatrix();
    T.translation() = at + noise_m * Eigen::Vector3d(random.normal(), 0, random.normal());
    path.push_back({i, 100'000'000LL * i, T, true});
  }
  return path;
}

Trajectory inverse(Trajectory path) {
  for (TrajectoryPose& pose : path) pose.T_world_camera = pose.T_world_camera.inverse();
  return path;
}

Trajectory motions(const Trajectory& path) {
  Trajectory result = path;
  for (std::size_t i = 1; i < path.size(); ++i) {
    result[i].T_world_camera = path[i - 1].T_world_camera.inverse() * path[i].T_world_camera;
  }
  return result;
}

/// Positions of the camera, but rotations from world to camera.
Trajectory withTransposedRotations(Trajectory path) {
  for (TrajectoryPose& pose : path) {
    pose.T_world_camera.linear() = pose.T_world_camera.linear().transpose().eval();
  }
  return path;
}

std::string hint(const Trajectory& truth, const Trajectory& estimate) {
  return poseReadingHint(test::paired(truth, estimate));
}

}  // namespace

TEST_CASE("two files of poses that are world to camera, or motions from frame to frame") {
  const Trajectory truth = drive(0);
  const Trajectory estimate = drive(0.05);
  CHECK(hint(truth, estimate).empty());
  CHECK_THAT(hint(inverse(truth), inverse(estimate)), Catch::Contains("are both world to camera?"));
  CHECK_THAT(hint(motions(truth), motions(estimate)),
             Catch::Contains("motions from frame to frame: are they?"));
  CHECK_THAT(hint(withTransposedRotations(truth), withTransposedRotations(estimate)),
             Catch::Contains("if every rotation is transposed"));
  for (const Alignment alignment : {Alignment::Se3, Alignment::Sim3, Alignment::None}) {
    CHECK_THAT(scoreTrajectory(inverse(truth), inverse(estimate), alignment).warning,
               Catch::StartsWith("both trajectories move in all directions"));
  }
}

TEST_CASE("a camera that is carried has no direction of its own, a straight road no turns") {
  const Trajectory carried = drive(0, 1);
  CHECK(hint(carried, drive(0.02, 1)).empty());
  CHECK(hint(inverse(carried), inverse(drive(0.02, 1))).empty());
  CHECK(hint(withTransposedRotations(carried), withTransposedRotations(carried)).empty());
  Trajectory straight = drive(0);
  for (std::size_t i = 0; i < straight.size(); ++i) {
    straight[i].T_world_camera = Eigen::Translation3d(0, 0, static_cast<double>(i));
  }
  CHECK(hint(inverse(straight), inverse(straight)).empty());
  Trajectory far_away = carried;  // from the origin, looking one way
  for (TrajectoryPose& pose : far_away) {
    pose.T_world_camera.translation() =
        Eigen::Vector3d(0, 0, 1000) + 0.01 * pose.T_world_camera.translation();
  }
  CHECK(hint(far_away, far_away).empty());
  CHECK(hint(drive(0, 0, 20), drive(0, 0, 20)).empty());
  Trajectory to_and_fro = straight;
  for (std::size_t i = 0; i < to_and_fro.size(); ++i) {
    const auto step = static_cast<double>(i % 40);
    to_and_fro[i].T_world_camera = Eigen::Translation3d(0, 0, std::min(step, 40 - step));
  }
  CHECK(hint(to_and_fro, to_and_fro).empty());
}
