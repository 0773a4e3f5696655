// SPDX-License-Identifier: BSD-3-Clause
// The plugin as the host calls it: experiences, loops, lost and unknown places, arrays.
#include <catch2/catch.hpp>
#include <cstring>
#include <numbers>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;
using namespace tolman::bayesian_attractor::test;

namespace {

/// Laps of a ring road with 40 templates, 4 m apart.
Decision lapFrame(BayesianAttractor& plugin, int frame, double drift = 0) {
  const auto seen = frame < 40 ? novel(frame) : measured(frame % 40);
  return step(plugin, motionOf({4, 0, 2 * std::numbers::pi / 40 + drift}, frame), seen);
}

/// A random walk with random views; returns the numbers of all decisions.
std::vector<double> randomDrive(BayesianAttractor& plugin, std::uint64_t seed, int frames) {
  RandomStream random(seed);
  std::vector<double> answers;
  std::int64_t templates = 0;
  for (int i = 0; i < frames; ++i) {
    Motion motion = motionOf({3 * random.normal(), random.normal(), random.normal()}, i);
    if (random.below(8) == 0) motion.state = TrackingState::Lost;
    if (random.below(200) == 0) motion.state = TrackingState::Initialising;
    PlaceObservation seen = nothing();
    const std::uint64_t kind = random.below(4);
    if (kind == 0 || templates == 0) seen = novel(templates++);
    if (kind == 1) seen = familiar(static_cast<std::int64_t>(random.below(200)), random.normal());
    if (kind == 2) {
      seen = measured(static_cast<std::int64_t>(random.below(20)),
                      {random.normal(), random.normal(), random.normal()});
    }
    const Decision d = step(plugin, motion, seen);
    CHECK(firstInvalidField(d).empty());
    CHECK((d.heading >= 0 && d.heading < 6.2831853072));
    CHECK((d.confidence >= 0 && d.confidence <= 1));
    answers.insert(answers.end(), {static_cast<double>(d.action), static_cast<double>(d.experience),
                                   d.relative_yaw, d.heading, d.confidence});
  }
  return answers;
}

}  // namespace

TEST_CASE("a second lap closes loops with spacing, to the experience of the view") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  for (int frame = 0; frame < 40; ++frame) {
    CHECK(lapFrame(plugin, frame).action != Action::CloseLoop);
  }
  int loops = 0;
  for (int frame = 40; frame < 80; ++frame) {
    const Decision decision = lapFrame(plugin, frame);
    if (decision.action != Action::CloseLoop) continue;
    CHECK(decision.template_id == frame % 40);
    CHECK(decision.has_relative_pose);
    CHECK(decision.confidence > 0.98);
    ++loops;
  }
  CHECK(loops >= 18);  // one for each 5 m, views come each 4 m
  CHECK(loops <= 20);
}

TEST_CASE("a loop of one view has its measured pose, seen from the experience") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  step(plugin, motionOf({0, 0, 0}, 0), nothing());
  step(plugin, motionOf({0.6, 0, 0.1}, 1), novel(0));  // in experience 0, 0.6 m further
  for (int i = 2; i < 62; ++i) {
    step(plugin, motionOf({2, 0, 2 * std::numbers::pi / 60}, i), nothing());
  }
  const PlaceObservation seen = measured(0, {0.2, -0.1, 0.02});
  const Decision decision = step(plugin, motionOf({0, 0, 0}, 62), seen);
  REQUIRE(decision.action == Action::CloseLoop);
  CHECK(decision.experience == 0);
  const PlanarPose expected = compose({0.6, 0, 0.1}, {0.2, -0.1, 0.02});
  const PlanarPose pose = toPlanar(decision.T_experience_current);
  CHECK(pose.x == Approx(expected.x));
  CHECK(pose.y == Approx(expected.y));
  CHECK(decision.relative_yaw == Approx(0.12));
  CHECK(decision.covariance == seen.covariance);
}

TEST_CASE("when a bump of several views is accepted, the loops of all its views are reported") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  for (int frame = 0; frame < 40; ++frame) lapFrame(plugin, frame, frame == 20 ? 0.5 : 0);
  Motion carried = motionOf({0, 0, 0}, 40);
  carried.state = TrackingState::Initialising;
  step(plugin, carried, nothing());
  const int first = 45;
  int frame = first;
  Decision decision;
  while (decision.action != Action::CloseLoop && frame < 60) {
    CHECK(decision.earlier.empty());
    decision = lapFrame(plugin, frame++);
  }
  REQUIRE(decision.action == Action::CloseLoop);
  CHECK(toPlanar(decision.T_experience_current).x == Approx(0).margin(1e-9));
  // Views come each 4 m, loops at most each 5 m: every second view, and none of the last 5 m.
  REQUIRE(decision.earlier.size() == static_cast<std::size_t>((frame - 1 - first) / 2));
  for (std::size_t i = 0; i < decision.earlier.size(); ++i) {
    const EarlierLoop& loop = decision.earlier[i];
    CHECK(loop.frame == first + 2 * static_cast<std::int64_t>(i));
    CHECK(loop.experience == loop.frame % 40);  // each template was made at its own experience
    CHECK(loop.T_experience_camera.isApprox(Eigen::Isometry3d::Identity()));
    CHECK(loop.covariance == measured(0).covariance);
  }
  CHECK(plugin.state().waiting.of(0, 1e9).size() <= decision.earlier.size() + 1);
  CHECK(lapFrame(plugin, frame).earlier.empty());
  CHECK(plugin.state().waiting.list().empty());
}

TEST_CASE("views without measured pose wait as loops as uncertain as they are") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  for (int frame = 0; frame < 40; ++frame) lapFrame(plugin, frame, frame == 20 ? 0.5 : 0);
  Motion carried = motionOf({0, 0, 0}, 40);
  carried.state = TrackingState::Initialising;
  step(plugin, carried, nothing());
  step(plugin, motionOf({4, 0, 2 * std::numbers::pi / 40}, 41), familiar(5, 0.1));
  const std::vector<WaitingLoop>& waiting = plugin.state().waiting.list();
  REQUIRE(waiting.size() == 1);
  CHECK(waiting[0].loop.frame == 41);
  CHECK(toPlanar(waiting[0].loop.T_experience_camera).theta == Approx(0.1));
  CHECK(waiting[0].loop.covariance(0, 0) == Approx(9));
  CHECK(waiting[0].loop.covariance(4, 4) == Approx(0.04));
}

TEST_CASE("without any view the map still gets its experiences") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  CHECK(step(plugin, motionOf({0, 0, 0}), nothing()).action == Action::CreateExperience);
  int made = 1;
  for (int i = 1; i <= 100; ++i) {
    made += step(plugin, motionOf({1, 0, 0.01}, i), nothing()).action == Action::CreateExperience;
  }
  CHECK(made == 17);  // every sixth: the chord of five is a little less than 5 m
  CHECK(step(plugin, motionOf({0, 0, 0}, 101), nothing()).heading == Approx(1.0));
}

TEST_CASE("after a gap in tracking a new experience is made, once") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  for (int frame = 0; frame < 30; ++frame) lapFrame(plugin, frame);
  Motion unknown = motionOf({0, 0, 0}, 30);
  unknown.state = TrackingState::Initialising;
  CHECK(step(plugin, unknown, nothing()).action == Action::CreateExperience);
  CHECK(step(plugin, unknown, nothing()).action == Action::Stay);
}

TEST_CASE("random inputs never give NaN, and experience ids stay dense") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  const std::vector<double> answers = randomDrive(plugin, 5, 1500);
  double next = 0;
  for (std::size_t i = 0; i < answers.size(); i += 5) {
    if (answers[i] == static_cast<double>(Action::CreateExperience))
      CHECK(answers[i + 1] == next++);
    CHECK(answers[i + 1] < next);
  }
}

TEST_CASE("reset equals a fresh instance, bit by bit") {
  BayesianAttractor used;
  BayesianAttractor fresh;
  REQUIRE(configure(used, {}).isOk());
  REQUIRE(configure(fresh, {}).isOk());
  randomDrive(used, 6, 300);
  REQUIRE(used.reset().isOk());
  const auto a = randomDrive(used, 7, 400);
  const auto b = randomDrive(fresh, 7, 400);
  CHECK(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

TEST_CASE("wrong input is refused, an unannounced template is learned") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  Decision decision;
  CHECK(plugin.step(motionOf({0, 0, 0}), familiar(-1), decision).code() ==
        StatusCode::InvalidInput);
  CHECK(step(plugin, motionOf({0, 0, 0}), familiar(4000000000)).action == Action::CreateExperience);
}
