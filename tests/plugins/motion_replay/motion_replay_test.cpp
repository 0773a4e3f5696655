// SPDX-License-Identifier: BSD-3-Clause
// Replayed odometry: exact by default, otherwise with the requested noise and bias.
#include "motion_replay.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/context.hpp"

using namespace tolman;
using namespace tolman::motion_replay;
using tolman::test::TestContext;

namespace {

Frame frameWith(std::int64_t index, const PlanarPose& step) {
  Frame frame;
  frame.frame = index;
  frame.stamp_ns = index * 100'000'000;
  frame.sensors.push_back(
      {"motion.planar",
       {3},
       {static_cast<float>(step.x), static_cast<float>(step.y), static_cast<float>(step.theta)}});
  return frame;
}

/// The motions of 4000 equal steps, after the first frame.
std::vector<Motion> replay(const ParameterValues& values, const PlanarPose& step,
                           std::uint64_t seed = 1) {
  TestContext context(values, seed);
  MotionReplay odometry;
  REQUIRE(odometry.configure(context).isOk());
  std::vector<Motion> motions;
  for (std::int64_t i = 0; i <= 4000; ++i) {
    Motion motion;
    REQUIRE(odometry.track(frameWith(i, step), motion).isOk());
    if (i > 0) motions.push_back(motion);
  }
  return motions;
}

struct Spread {
  double mean = 0;
  double deviation = 0;
};

template <class Value>
Spread spreadOf(const std::vector<Motion>& motions, const Value& value) {
  double sum = 0;
  double squares = 0;
  for (const Motion& motion : motions) {
    sum += value(motion);
    squares += value(motion) * value(motion);
  }
  const auto n = static_cast<double>(motions.size());
  return {sum / n, std::sqrt(std::max(0.0, squares / n - sum / n * (sum / n)))};
}

double forward(const Motion& motion) { return toPlanar(motion.T_previous_current).x; }
double sink(const Motion& motion) { return motion.T_previous_current.translation().y(); }
double turn(const Motion& motion) { return toPlanar(motion.T_previous_current).theta; }

}  // namespace

TEST_CASE("by default the motion is the recorded one, with the paper's velocities") {
  for (const Motion& motion : replay({}, {0.8, 0.1, 0.02})) {
    REQUIRE(motion.state == TrackingState::Tracking);
    const PlanarPose step = toPlanar(motion.T_previous_current);
    REQUIRE(step.x == Approx(0.8));
    REQUIRE(step.y == Approx(0.1));
    REQUIRE(step.theta == Approx(0.02));
    REQUIRE(motion.v == Approx(std::hypot(0.8, 0.1) / 0.1));
    REQUIRE(motion.omega == Approx(0.2));
  }
}

TEST_CASE("the first frame is initialising and still") {
  TestContext context;
  MotionReplay odometry;
  REQUIRE(odometry.configure(context).isOk());
  Motion motion;
  REQUIRE(odometry.track(frameWith(0, {1, 0, 0}), motion).isOk());
  CHECK(motion.state == TrackingState::Initialising);
  CHECK(motion.T_previous_current.isApprox(Eigen::Isometry3d::Identity()));
}

TEST_CASE("a source says at which frames the motion is unknown") {
  TestContext context;
  MotionReplay odometry;
  REQUIRE(odometry.configure(context).isOk());
  for (std::int64_t i = 0; i < 6; ++i) {
    Frame frame = frameWith(i, {1, 0, 0});
    frame.sensors.push_back({"motion.unknown", {1}, {i == 3 ? 1.0F : 0.0F}});
    Motion motion;
    REQUIRE(odometry.track(frame, motion).isOk());
    const bool unknown = i == 0 || i == 3;
    CHECK((motion.state == TrackingState::Initialising) == unknown);
    CHECK(forward(motion) == Approx(unknown ? 0 : 1));
  }
}

TEST_CASE("a source says at which frames its motion is a guess: they are lost") {
  TestContext context;
  MotionReplay odometry;
  REQUIRE(odometry.configure(context).isOk());
  double measured = 0;  // variance
  for (std::int64_t i = 0; i < 6; ++i) {
    const bool guessed = i == 3 || i == 4;
    Frame frame = frameWith(i, {i == 3 ? 0.5 : i == 4 ? 0 : 1.0, 0, 0});
    frame.sensors.push_back({"motion.lost", {1}, {guessed ? 1.0F : 0.0F}});
    Motion motion;
    REQUIRE(odometry.track(frame, motion).isOk());
    if (i == 0) continue;
    CHECK(motion.state == (guessed ? TrackingState::Lost : TrackingState::Tracking));
    CHECK(forward(motion) == Approx(i == 3 ? 0.5 : i == 4 ? 0 : 1).margin(1e-9));
    if (i == 2) measured = motion.covariance(0, 0);
    if (guessed) CHECK(motion.covariance(0, 0) == Approx(100 * measured));
    if (guessed) CHECK(motion.tracked == 0);
  }
}

TEST_CASE("noise and bias have the sizes asked for") {
  const auto noisy = replay({{"noise_distance", 0.1}, {"noise_heading", 0.01}}, {4, 0, 0});
  CHECK(spreadOf(noisy, forward).mean == Approx(4).epsilon(0.01));
  CHECK(spreadOf(noisy, forward).deviation == Approx(0.4).epsilon(0.05));
  CHECK(spreadOf(noisy, turn).deviation == Approx(0.02).epsilon(0.05));  // root of 4 m
  const auto biased =
      replay({{"bias_distance", 0.05}, {"bias_heading", 0.001}, {"bias_height", 0.003}}, {4, 0, 0});
  CHECK(spreadOf(biased, forward).mean == Approx(4.2));
  CHECK(spreadOf(biased, turn).mean == Approx(0.004));
  CHECK(spreadOf(biased, sink).mean == Approx(0.003 * 4.2));
}

TEST_CASE("lost frames are a share, say so, and are predicted with a wider covariance") {
  const auto motions = replay({{"lost", 0.25}}, {1, 0, 0});
  std::size_t lost = 0;
  for (const Motion& motion : motions) {
    if (motion.state != TrackingState::Lost) continue;
    ++lost;
    CHECK(forward(motion) <= 1.0 + 1e-6);
    CHECK(motion.covariance(0, 0) > 1e-4);
  }
  CHECK(static_cast<double>(lost) == Approx(1000).epsilon(0.1));
}

TEST_CASE("a seed gives one replay, after reset as well") {
  const ParameterValues values = {{"noise_heading", 0.01}};
  const auto first = replay(values, {1, 0, 0}, 5);
  const auto second = replay(values, {1, 0, 0}, 5);
  const auto other = replay(values, {1, 0, 0}, 6);
  CHECK(turn(first[77]) == turn(second[77]));
  CHECK(turn(first[77]) != turn(other[77]));
}

TEST_CASE("a source with images only is refused with a remedy") {
  TestContext context;
  MotionReplay odometry;
  REQUIRE(odometry.configure(context).isOk());
  Motion motion;
  Frame frame;
  frame.frame = 0;
  const Status status = odometry.track(frame, motion);
  CHECK(status.code() == StatusCode::Unsupported);
  CHECK(status.message() ==
        "this source measures no motion.planar; use one that does, such as motion_log or a ROS bag "
        "with an odometry topic, or another odometry");
}
