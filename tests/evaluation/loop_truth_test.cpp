// SPDX-License-Identifier: BSD-3-Clause
// Revisits compared with hand-made routes, an exhaustive search, and real drives.
#include <catch2/catch.hpp>
#include <chrono>
#include <iostream>
#include <limits>
#include <numbers>

#include "evaluation/loops.hpp"
#include "evaluation/paths.hpp"
#include "evaluation/trajectory.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Drives on: each step is `metres` ahead and a turn to the left of `degrees`.
void drive(Trajectory& path, int steps, double metres, double degrees) {
  PlanarPose pose = path.empty() ? PlanarPose{} : toPlanar(path.back().T_world_camera);
  for (int i = 0; i < steps; ++i) {
    if (!path.empty()) pose = compose(pose, {metres, 0, degrees * kDegree});
    const auto frame = static_cast<std::int64_t>(path.size());
    path.push_back({frame, frame * 100'000'000, fromPlanar(pose)});
  }
}

/// A round of 100 m in 100 frames and a bit more.
Trajectory roundAndOn() {
  Trajectory path;
  drive(path, 121, 1, 3.6);
  return path;
}

/// The rule as it reads, over all pairs; shares nothing with the implementation but the distances.
std::vector<Revisit> exhaustive(const Trajectory& path, const RevisitRule& rule) {
  std::vector<Revisit> found;
  for (std::size_t i = 0; i < path.size(); ++i) {
    for (const Heading heading : {Heading::Same, Heading::Opposite}) {
      Revisit best{path[i].frame, -1, heading, std::numeric_limits<double>::infinity()};
      double driven = 0;
      for (std::size_t j = i; j-- > 0;) {
        const Eigen::Isometry3d step =
            path[j].T_world_camera.inverse() * path[j + 1].T_world_camera;
        driven += step.translation().norm();
        const Eigen::Isometry3d apart = path[j].T_world_camera.inverse() * path[i].T_world_camera;
        const Eigen::Vector3d ahead = apart.linear() * Eigen::Vector3d::UnitZ();
        const double turn = std::atan2(ahead.head<2>().norm(), ahead.z()) / kDegree;
        const bool turned =
            heading == Heading::Same ? turn < rule.same_below_deg : turn > rule.opposite_above_deg;
        const double distance = apart.translation().norm();
        if (driven <= rule.path_m || distance > rule.distance_m || !turned) continue;
        if (distance < best.distance_m + 1e-12) best.earlier = path[j].frame;
        best.distance_m = std::min(best.distance_m, distance);
      }
      if (best.earlier >= 0) found.push_back(best);
    }
  }
  return found;
}

void checkEqual(const std::vector<Revisit>& ours, const std::vector<Revisit>& expected) {
  REQUIRE(ours.size() == expected.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    INFO("revisit " << i << ", frame " << ours[i].frame);
    CHECK(ours[i].frame == expected[i].frame);
    CHECK(ours[i].earlier == expected[i].earlier);
    CHECK(ours[i].heading == expected[i].heading);
    CHECK(ours[i].distance_m == Approx(expected[i].distance_m).margin(1e-9));
  }
}

std::size_t countOf(const std::vector<Revisit>& revisits, Heading heading) {
  return static_cast<std::size_t>(
      std::count_if(revisits.begin(), revisits.end(),
                    [&](const Revisit& revisit) { return revisit.heading == heading; }));
}

}  // namespace

TEST_CASE("a straight road sees nothing again") {
  CHECK(findRevisits(test::straightPath(500)).empty());
  CHECK(findRevisits({}).empty());
  CHECK(findRevisits(test::straightPath(1)).empty());
}

TEST_CASE("the second time around the block meets the first, frame by frame") {
  const auto revisits = findRevisits(roundAndOn());
  // The chord of the last 5 m before the start: those frames are near frame 0 already.
  REQUIRE(revisits.front().frame == 95);
  CHECK(revisits.front().earlier == 0);
  CHECK(revisits.front().heading == Heading::Same);
  REQUIRE(revisits.back().frame == 120);
  CHECK(revisits.back().earlier == 20);
  CHECK(revisits.back().distance_m == Approx(0).margin(1e-9));
  CHECK(countOf(revisits, Heading::Opposite) == 0);
}

TEST_CASE("the way back through a street is a revisit in the opposite direction") {
  Trajectory path;
  drive(path, 61, 1, 0);     // 60 m along x
  drive(path, 10, 0.5, 18);  // a turn on the spot, nearly: 1.6 m to the left
  drive(path, 60, 1, 0);
  const auto revisits = findRevisits(path);
  CHECK(countOf(revisits, Heading::Same) == 0);
  REQUIRE(countOf(revisits, Heading::Opposite) > 40);
  for (const Revisit& revisit : revisits) {
    if (revisit.frame < 85) continue;  // what is nearest there has been driven less than 20 m ago
    const double ahead =
        path[static_cast<std::size_t>(revisit.frame)].T_world_camera.translation().z();
    CHECK(static_cast<double>(revisit.earlier) == Approx(ahead).margin(0.51));
  }
}

TEST_CASE("crossing a street at a right angle is neither direction") {
  Trajectory path;
  drive(path, 101, 1, 0);
  drive(path, 90, 0.5, 3);  // three quarters of a turn, and over the street at a right angle
  drive(path, 60, 1, 0);
  const auto crossing = toPlanar(path.back().T_world_camera);
  REQUIRE(std::abs(std::abs(crossing.theta) - 90 * kDegree) < 1e-9);
  const auto revisits = findRevisits(path);
  for (const Revisit& revisit : revisits) CHECK(revisit.frame < 191);
}

TEST_CASE("a car that waits does not see itself again") {
  Trajectory path = test::straightPath(50);
  for (int i = 0; i < 500; ++i) {
    path.push_back(path.back());
    ++path.back().frame;
  }
  CHECK(findRevisits(path).empty());
}

TEST_CASE("a bridge over a street is another place") {
  Trajectory path = roundAndOn();
  CHECK_FALSE(findRevisits(path).empty());
  for (auto& pose : path) {
    if (pose.frame >= 50) pose.T_world_camera.translation().y() -= 6;  // y is down
  }
  CHECK(findRevisits(path).empty());
}

TEST_CASE("frames keep the numbers of the trajectory, which may have gaps") {
  Trajectory path = roundAndOn();
  for (auto& pose : path) pose.frame = 10 * pose.frame + 7;
  const auto revisits = findRevisits(path);
  CHECK(revisits.back().frame == 1207);
  CHECK(revisits.back().earlier == 207);
}

TEST_CASE("the same pairs as an exhaustive search, wherever the path lies") {
  RandomStream random(11);
  for (int trial = 0; trial < 6; ++trial) {
    Trajectory path;
    drive(path, 1, 0, 0);
    for (int i = 0; i < 60; ++i) drive(path, 8, random.uniform(0.2, 1.5), random.uniform(-4, 14));
    path = test::moved(path, test::randomPose(random));
    RevisitRule rule;
    if (trial % 2 == 1) rule = {2.5, 30, 30, 150};
    const auto expected = exhaustive(path, rule);
    CHECK(expected.size() > 10);
    checkEqual(findRevisits(path, rule), expected);
  }
}

TEST_CASE("through all of space, too") {
  RandomStream random(12);
  const Trajectory path = test::wanderingPath(800, random);
  const auto expected = exhaustive(path, {});
  CHECK(expected.size() > 50);
  checkEqual(findRevisits(path), expected);
}

TEST_CASE("loops.txt has a comment and one line a revisit") {
  const std::vector<Revisit> revisits = {{96, 0, Heading::Same, 4.0015},
                                         {97, 12, Heading::Opposite, 0.25}};
  CHECK(loopsText(revisits) ==
        "# frame earlier same|opposite distance_m; within 5 m after more than 20 m\n"
        "96 0 same 4.002\n"
        "97 12 opposite 0.250\n");
  CHECK(loopsText({}).starts_with("# "));
}

TEST_CASE("KITTI 00 and 06 see places again, in the same direction", "[data]") {
  struct Drive {
    const char* sequence;
    std::int64_t first;  // before this frame nothing is seen again
    double share;        // of the frames, at least
  };
  for (const Drive& expected : {Drive{"00", 1500, 0.15}, Drive{"06", 800, 0.2}}) {
    const auto file = test::dataOrSkip(std::string("kitti_poses/") + expected.sequence + ".txt");
    if (!file) return;
    const Trajectory path = readTrajectory(*file).value();
    const auto begin = std::chrono::steady_clock::now();
    const auto revisits = findRevisits(path);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    std::cout << "KITTI " << expected.sequence << ": " << path.size() << " frames, "
              << countOf(revisits, Heading::Same) << " seen again in the same direction, "
              << countOf(revisits, Heading::Opposite) << " in the opposite one, from frame "
              << revisits.front().frame << "; " << time.count() << " ms\n";
    CHECK(static_cast<double>(countOf(revisits, Heading::Same)) >
          expected.share * static_cast<double>(path.size()));
    checkEqual(revisits, exhaustive(path, {}));
  }
}
