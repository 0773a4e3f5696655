// SPDX-License-Identifier: BSD-3-Clause
// Chains in degrees and in mm, against the same ones in radians and metres.
#include "unit_doubts.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <numbers>

#include "motion_log.hpp"
#include "support/context.hpp"
#include "support/data.hpp"

namespace tolman::motion_log {
namespace {

constexpr double kRate = 10;  // Hz
constexpr double kDegrees = 180 / std::numbers::pi;

/// A car of 8 m/s that drives straight on and turns by 0.3 rad/s for a tenth of the way.
std::vector<PlanarPose> stepsOf(double length_unit, double angle_unit) {
  std::vector<PlanarPose> steps;
  for (int i = 0; i < 600; ++i) {
    const double turn = i % 100 < 10 ? 0.03 : 0.0005 * std::sin(i);
    steps.push_back({0.8 * length_unit, 0, turn * angle_unit});
  }
  return steps;
}

std::vector<std::string> doubtsOf(const std::vector<PlanarPose>& steps) {
  std::vector<PlanarPose> poses = {{}};
  for (const PlanarPose& step : steps) poses.push_back(compose(poses.back(), step));
  return unitDoubts(poses, kRate);
}

/// Three rounds of 600 frames; each tenth frame of the later rounds looks like that a round before,
/// from up to 1.5 m beside it and turned by up to 0.06 rad.
std::vector<Edge> candidatesOf(double length_unit, double angle_unit) {
  std::vector<Edge> candidates;
  for (int from = 600; from < 1800; from += 10) {
    const double side = 1.5 * std::sin(from);
    candidates.push_back(
        {from, from - 600, {0, side * length_unit, 0.06 * std::cos(from) * angle_unit}, 0});
  }
  return candidates;
}

/// Poses on a circle of 600 steps of 0.8 m, by an odometry that drifts by 0.1 rad a round.
std::vector<PlanarPose> rounds() {
  std::vector<PlanarPose> poses = {{}};
  const double turn = (2 * std::numbers::pi + 0.1) / 600;
  for (int i = 1; i < 1800; ++i) poses.push_back(compose(poses.back(), {0.8, 0, turn}));
  return poses;
}

void write(const std::filesystem::path& file, const std::vector<PlanarPose>& steps) {
  std::ofstream text(file);
  text << std::setprecision(17);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    text << "EDGE_SE2 " << i << ' ' << i + 1 << ' ' << steps[i].x << ' ' << steps[i].y << ' '
         << steps[i].theta << " 1 0 0 1 0 1\n";
  }
}

}  // namespace

TEST_CASE("degrees and mm are asked about once, whatever the number of steps") {
  CHECK(doubtsOf(stepsOf(1, 1)).empty());
  const auto degrees = doubtsOf(stepsOf(1, kDegrees));
  REQUIRE(degrees.size() == 1);
  CHECK(degrees[0].starts_with("60 of 600 steps turn faster than 10 rad/s; are its angles in deg"));
  const auto mm = doubtsOf(stepsOf(1000, 1));
  REQUIRE(mm.size() == 1);
  CHECK(mm[0].starts_with("600 of 600 steps are faster than 100 m/s; are its lengths in mm or cm"));
  CHECK(doubtsOf(stepsOf(1000, kDegrees)).size() == 2);
  CHECK(doubtsOf({}).empty());
}

TEST_CASE("loop candidates in degrees, mm and cm are asked about once") {
  CHECK(candidateDoubts(candidatesOf(1, 1), rounds()).empty());
  CHECK(candidateDoubts({}, rounds()).empty());
  const auto degrees = candidateDoubts(candidatesOf(1, kDegrees), rounds());
  REQUIRE(degrees.size() == 1);
  CHECK(degrees[0].starts_with("the angles of 120 loop candidates agree with the odometry far "));
  for (const double unit : {100.0, 1000.0}) {
    const auto lengths = candidateDoubts(candidatesOf(unit, 1), rounds());
    REQUIRE(lengths.size() == 1);
    CHECK(lengths[0].find(" of 120 loop candidates with a length lead further than 100 m or ") !=
          std::string::npos);
  }
  CHECK(candidateDoubts(candidatesOf(1000, kDegrees), rounds()).size() == 2);
}

TEST_CASE("candidates without motion, seen from behind, and a few wrong ones are no sign") {
  CHECK(candidateDoubts(candidatesOf(0, 0), rounds()).empty());
  std::vector<Edge> candidates = candidatesOf(1, 1);
  for (const std::size_t wrong : {3U, 40U, 90U}) candidates[wrong].motion = {150, 3, 2};
  CHECK(candidateDoubts(candidates, rounds()).empty());
  CHECK(candidateDoubts({{800, 100, {1, 0, 3}, 0}}, rounds()).empty());
}

TEST_CASE("a few wild steps are no sign of other units") {
  std::vector<PlanarPose> steps = stepsOf(1, 1);
  for (const std::size_t wild : {5U, 50U, 300U}) steps[wild] = {40, 3, 2};
  CHECK(doubtsOf(steps).empty());
}

TEST_CASE("the file is named, of the truth as well, by run and by check") {
  const test::TemporaryFolder folder;
  write(folder.path() / "odometry.g2o", stepsOf(1, 1));
  write(folder.path() / "ground_truth.g2o", stepsOf(1, kDegrees));
  test::TestContext context(
      {{"path", folder.path().string()}, {"candidates", std::string()}, {"rate", kRate}});
  MotionLog source;
  REQUIRE(source.configure(context).isOk());
  REQUIRE(context.findings.size() == 1);
  const std::string truth = (folder.path() / "ground_truth.g2o").string();
  CHECK(context.findings[0].message.starts_with("60 of 600 steps turn faster"));
  CHECK(context.findings[0].severity == Finding::Severity::Warning);
  CHECK(context.findings[0].where == truth);
}

TEST_CASE("KITTI's loop candidates, as they are and in other units", "[data]") {
  const auto path = test::dataOrSkip("kitti_motion");
  if (!path) return;
  for (const std::string drive : {"00", "02", "05", "06"}) {
    INFO(drive);
    const auto poses = readChain(*path / drive / "odometry.g2o");
    const auto edges = readEdges(*path / drive / "loop_candidates.g2o");
    REQUIRE(poses.isOk());
    REQUIRE(edges.isOk());
    const auto doubts = [&](double length_unit, double angle_unit) {
      std::vector<Edge> scaled = edges.value();
      for (Edge& edge : scaled) {
        edge.motion = {edge.motion.x * length_unit, edge.motion.y * length_unit,
                       edge.motion.theta * angle_unit};
      }
      return candidateDoubts(scaled, poses.value()).size();
    };
    CHECK(doubts(1, 1) == 0);
    CHECK(doubts(1000, 1) == 1);
    CHECK(doubts(100, 1) == 1);
    CHECK(doubts(1, kDegrees) == 1);
  }
}

TEST_CASE("doubts of candidates name their file") {
  const test::TemporaryFolder folder;
  write(folder.path() / "odometry.g2o", stepsOf(1, 1));
  std::ofstream text(folder.path() / "loop_candidates.g2o");
  for (int i = 0; i < 10; ++i) text << "EDGE_SE2 " << 300 + i << " 5 0 1500 0 1 0 0 1 0 1\n";
  text.close();
  test::TestContext context({{"path", folder.path().string()}, {"rate", kRate}});
  MotionLog source;
  REQUIRE(source.configure(context).isOk());
  REQUIRE(context.findings.size() == 1);
  CHECK((context.findings[0].where + ": " + context.findings[0].message)
            .starts_with((folder.path() / "loop_candidates.g2o").string() +
                         ": 10 of 10 loop candidates with a length lead further"));
}

}  // namespace tolman::motion_log
