// SPDX-License-Identifier: BSD-3-Clause
// Chains in degrees and in mm, against the same ones in radians and metres.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <numbers>

#include "g2o_edges.hpp"
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

}  // namespace tolman::motion_log
