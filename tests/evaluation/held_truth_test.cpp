// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/held_truth.hpp"

#include <catch2/catch.hpp>

#include "evaluation/metrics.hpp"
#include "evaluation/paths.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

/// The path with the poses after `first`, up to `last`, replaced by that of `first`.
Trajectory held(Trajectory path, std::size_t first, std::size_t last) {
  for (std::size_t i = first + 1; i <= last; ++i) {
    path[i].T_world_camera = path[first].T_world_camera;
  }
  return path;
}

std::string hintOf(const Trajectory& truth, const Trajectory& estimate) {
  return heldHint(test::paired(truth, estimate));
}

/// A path in which the robot stands between two drives of equal steps, with noise of its estimate.
Trajectory stopAndGo(double noise_m, RandomStream& random) {
  Trajectory path = test::straightPath(200);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::size_t driven = i < 50 ? i : i < 150 ? 50 : i - 100;
    path[i].T_world_camera.translation().z() =
        0.1 * static_cast<double>(driven) + noise_m * random.normal();
  }
  return path;
}

}  // namespace

TEST_CASE("a truth that stands still while the estimate moves, and then jumps, is detected") {
  const Trajectory path = test::straightPath(60);
  const std::string expected =
      "the truth stands still from frame 10 to 16 while the estimate moves 6 m, and then jumps 7 m";
  CHECK(hintOf(held(path, 10, 16), path).starts_with(expected));
  CHECK(hintOf(held(path, 10, 12), path).starts_with("the truth stands still from frame 10 to 12"));
  CHECK(hintOf(held(path, 10, 11), path).empty());
  CHECK(hintOf(path, path).empty());
  Trajectory rate = path;  // every pose held for five frames
  for (std::size_t i = 0; i < rate.size(); ++i) {
    rate[i].T_world_camera = path[i - i % 5].T_world_camera;
  }
  CHECK(hintOf(rate, path).starts_with("the truth stands still from frame 0 to 4"));
  for (const Alignment alignment :
       {Alignment::None, Alignment::Se2, Alignment::Se3, Alignment::Sim3}) {
    const auto metrics = scoreTrajectory(held(path, 10, 16), path, alignment);
    CHECK_THAT(metrics.warning, Catch::StartsWith("the truth stands still from frame 10 to 16"));
    CHECK(scoreTrajectory(path, path, alignment).warning.empty());
  }
}

TEST_CASE("a truth that is held to its end, or from its start, or goes on late, is detected") {
  const Trajectory path = test::straightPath(200);
  CHECK_THAT(hintOf(held(path, 150, 199), path),
             Catch::StartsWith("the truth stands still from frame 150 to 199 while the estimate "
                               "moves 49 m: are poses held"));
  Trajectory late = path;  // the first 60 true poses are those of later frames
  for (std::size_t i = 0; i < 60; ++i) late[i].T_world_camera = path[60].T_world_camera;
  CHECK_THAT(hintOf(late, path), Catch::StartsWith("the truth stands still from frame 0 to 60"));
  Trajectory delayed = held(path, 50, 80);
  for (std::size_t i = 80; i < delayed.size(); ++i) {
    delayed[i].T_world_camera = path[i - 30].T_world_camera;
  }
  CHECK_THAT(hintOf(delayed, path), Catch::StartsWith("the truth stands still from frame 50 to"));
}

TEST_CASE("an estimate that stands still while the truth drives on is detected") {
  const Trajectory path = test::straightPath(200);
  CHECK_THAT(hintOf(path, held(path, 150, 199)),
             Catch::StartsWith("the estimate stands still from frame 150 to 199 while the truth "
                               "moves 49 m: is odometry lost"));
  Trajectory lost = held(path, 150, 199);  // it says so
  for (std::size_t i = 150; i < lost.size(); ++i) lost[i].tracked = false;
  CHECK(hintOf(path, lost).empty());
}

TEST_CASE("held poses are detected at any length of the path") {
  for (const double spacing : {0.01, 0.1, 30.0}) {
    const Trajectory path = test::straightPath(100, spacing);
    CHECK_FALSE(hintOf(held(path, 10, 29), path).empty());
  }
}

TEST_CASE("a robot that stands gives no hint, also with a noisy or drifting estimate") {
  RandomStream random(5);
  const Trajectory truth = stopAndGo(0, random);
  CHECK(hintOf(truth, truth).empty());
  for (const double noise_m : {0.001, 0.02, 0.1}) {
    CHECK(hintOf(truth, stopAndGo(noise_m, random)).empty());
  }
  Trajectory drifting = truth;
  for (std::size_t i = 50; i < drifting.size(); ++i) {
    drifting[i].T_world_camera.translation().x() +=
        0.01 * static_cast<double>(i < 150 ? i - 50 : 100);
  }
  CHECK(hintOf(truth, drifting).empty());
  CHECK(hintOf(test::straightPath(60, 0), test::straightPath(60)).empty());
}

TEST_CASE("a truth at a lower rate that is interpolated, and gaps, give no hint") {
  const Trajectory path = test::straightPath(60);
  Trajectory almost = held(path, 10, 16);  // as of a sensor
  for (std::size_t i = 0; i < almost.size(); ++i) {
    almost[i].T_world_camera.translation().x() += 1e-6 * static_cast<double>(i);
  }
  CHECK(hintOf(almost, path).empty());
  Trajectory sparse;  // true poses of every fifth frame only
  for (std::size_t i = 0; i < path.size(); i += 5) sparse.push_back(path[i]);
  CHECK(hintOf(sparse, path).empty());
  Trajectory lost = path;  // nothing is known where tracking is lost
  for (std::size_t i = 11; i <= 16; ++i) lost[i].tracked = false;
  CHECK(hintOf(held(path, 10, 16), lost).empty());
  Trajectory sessions = path;  // the step from one session to the next says nothing
  for (std::size_t i = 13; i < sessions.size(); ++i) sessions[i].session = 1;
  CHECK(hintOf(held(sessions, 10, 12), sessions).empty());
}

TEST_CASE("a single jump of the truth is detected, and one of the estimate is not") {
  const auto jumped = [](Trajectory path, std::size_t from, double length_m) {
    for (std::size_t i = from; i < path.size(); ++i) {
      path[i].T_world_camera.translation().x() += length_m;
    }
    return path;
  };
  const Trajectory path = test::straightPath(60);
  const auto hint = [](const Trajectory& truth, const Trajectory& estimate) {
    return jumpHint(test::paired(truth, estimate));
  };
  CHECK_THAT(hint(jumped(path, 20, 5), path),
             Catch::StartsWith("the truth jumps 5.1 m from frame 19 to 20, where its other steps "
                               "have 1 m (median) and the estimate moves 1 m"));
  CHECK(hint(jumped(path, 20, 3), path).empty());  // less than four steps
  CHECK(hint(path, jumped(path, 20, 5)).empty());
  CHECK(hint(jumped(path, 20, 5), jumped(path, 20, 5)).empty());
  CHECK_THAT(scoreTrajectory(jumped(path, 20, 5), path, Alignment::Se3).warning,
             Catch::StartsWith("the truth jumps"));
  Trajectory lost = path;  // where tracking is lost the estimate says nothing
  lost[20].tracked = false;
  CHECK(hint(jumped(path, 20, 5), lost).empty());
  Trajectory sessions = path;
  for (std::size_t i = 20; i < sessions.size(); ++i) sessions[i].session = 1;
  CHECK(hint(jumped(sessions, 20, 5), sessions).empty());
}

TEST_CASE("a robot that starts, stops and is noisy gives no hint of a jump") {
  RandomStream random(6);
  const Trajectory truth = stopAndGo(0, random);
  for (const double noise_m : {0.0, 0.02, 0.1}) {
    CHECK(jumpHint(test::paired(truth, stopAndGo(noise_m, random))).empty());
    CHECK(jumpHint(test::paired(stopAndGo(noise_m, random), truth)).empty());
  }
  const Trajectory wandering = test::wanderingPath(200, random);
  CHECK(jumpHint(test::paired(wandering, wandering)).empty());
}

TEST_CASE("true orientations that never turn while the estimate does are detected") {
  Trajectory path = test::straightPath(100);  // a circle
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double angle = 0.03 * static_cast<double>(i);
    path[i].T_world_camera.linear() =
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
    path[i].T_world_camera.translation() << 20 * (1 - std::cos(angle)), 0, 20 * std::sin(angle);
  }
  Trajectory fixed = path;
  for (auto& pose : fixed) pose.T_world_camera.linear().setIdentity();
  const auto hint = [](const Trajectory& truth, const Trajectory& estimate) {
    return fixedOrientationHint(test::paired(truth, estimate));
  };
  CHECK_THAT(
      hint(fixed, path),
      Catch::StartsWith("all true poses have the same orientation, but the estimate turns by "
                        "170 degrees"));
  CHECK(hint(path, path).empty());
  CHECK(hint(fixed, fixed).empty());                         // a robot that drives sideways
  CHECK_FALSE(hint(test::straightPath(100), path).empty());  // positions made of the angles
  CHECK_FALSE(scoreTrajectory(fixed, path, Alignment::None).warning.empty());
}
