// SPDX-License-Identifier: BSD-3-Clause
// The plugin as the host calls it: ordinary driving, missing views, lost odometry, arrays.
#include <catch2/catch.hpp>
#include <cstring>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::paper_attractor;
using namespace tolman::paper_attractor::test;

namespace {

/// A random walk with random views; returns the bytes of all decisions.
std::vector<double> randomDrive(PaperAttractor& plugin, std::uint64_t seed, int frames) {
  RandomStream random(seed);
  std::vector<double> answers;
  std::int64_t templates = 0;
  for (int i = 0; i < frames; ++i) {
    Motion motion = motionOf({3 * random.normal(), random.normal(), random.normal()}, i);
    if (random.below(8) == 0) motion.state = TrackingState::Lost;
    PlaceObservation seen = nothing();
    const std::uint64_t kind = random.below(4);
    if (kind == 0 || templates == 0) seen = novel(templates++);
    if (kind == 1) seen = familiar(static_cast<std::int64_t>(random.below(200)), random.normal());
    if (kind == 2) {
      seen = familiar(static_cast<std::int64_t>(random.below(20)));
      seen.has_relative_pose = random.below(2) == 0;
      seen.T_template_current = fromPlanar({random.normal(), random.normal(), random.normal()});
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

TEST_CASE("sixty metres of straight street: an experience every few metres, no loops") {
  PaperAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  std::int64_t last = -1;
  for (int i = 0; i < 51; ++i) {
    const auto seen = i % 5 == 0 ? novel(i / 5) : familiar(i / 5);
    const Decision d = step(plugin, motionOf({i == 0 ? 0 : 1.2, 0, 0}, i), seen);
    CHECK(d.frame == i);
    CHECK(d.stamp_ns == std::int64_t{i} * 100'000'000);
    CHECK(d.action != Action::CloseLoop);
    if (d.action == Action::CreateExperience) CHECK(d.experience == ++last);
    CHECK(d.experience == last);
  }
  CHECK(last + 1 >= 10);
  CHECK(last + 1 <= 20);
}

TEST_CASE("without any view the map still gets its experiences") {
  PaperAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  const Decision first = step(plugin, motionOf({0, 0, 0}), nothing());
  CHECK(first.action == Action::CreateExperience);
  CHECK(first.template_id == -1);
  int made = 1;
  for (int i = 1; i <= 100; ++i) {
    made += step(plugin, motionOf({1, 0, 0.01}, i), nothing()).action == Action::CreateExperience;
  }
  CHECK(made == 17);  // every sixth: the chord of five is a little less than 5 m
  CHECK(step(plugin, motionOf({0, 0, 0}, 101), nothing()).heading == Approx(1.0));
}

TEST_CASE("random inputs never give NaN, and experience ids stay dense") {
  PaperAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  const std::vector<double> answers = randomDrive(plugin, 5, 1500);
  double next = 0;
  for (std::size_t i = 0; i < answers.size(); i += 5) {
    if (answers[i] == static_cast<double>(Action::CreateExperience))
      CHECK(answers[i + 1] == next++);
    CHECK(answers[i + 1] < next);
  }
  for (const char* name : {"hd.activity", "hd.estimate", "grid.activity", "grid.estimate"}) {
    CHECK(detail::allFinite(arrayOf(plugin, name)));
  }
}

TEST_CASE("reset equals a fresh instance, bit by bit") {
  PaperAttractor used;
  PaperAttractor fresh;
  REQUIRE(configure(used, {}).isOk());
  REQUIRE(configure(fresh, {}).isOk());
  randomDrive(used, 6, 300);
  REQUIRE(used.reset().isOk());
  const auto a = randomDrive(used, 7, 400);
  const auto b = randomDrive(fresh, 7, 400);
  CHECK(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

TEST_CASE("the bumps as arrays: names, shapes, peaks") {
  PaperAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  step(plugin, motionOf({0, 0, 0}), novel(0));
  step(plugin, motionOf({25, 50, std::numbers::pi / 2}, 1), nothing());
  const auto ring = arrayOf(plugin, "hd.activity");
  REQUIRE(ring.size() == 36);
  CHECK(std::max_element(ring.begin(), ring.end()) - ring.begin() == 9);  // 90 deg
  CHECK(ring[9] == Approx(1));
  CHECK(ring[10] == Approx(std::exp(-0.5 * 100 * 0.17453 * 0.17453)).margin(1e-3));
  const auto sheet = arrayOf(plugin, "grid.activity");
  REQUIRE(sheet.size() == 900);  // half a cell each: x = 2.5 is column 5, y = 5 is row 10
  CHECK(std::max_element(sheet.begin(), sheet.end()) - sheet.begin() == 10 * 30 + 5);
  CHECK(arrayOf(plugin, "hd.integrator").size() == 2);
  CHECK(arrayOf(plugin, "grid.calibration").size() == 3);
  CHECK(arrayOf(plugin, "grid.injected")[2] == 0);
  CHECK(arrayOf(plugin, "grid.estimate")[0] == Approx(2.5));
}

TEST_CASE("wrong input is refused") {
  PaperAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  Decision decision;
  const Status status = plugin.step(motionOf({0, 0, 0}), familiar(-1), decision);
  CHECK(status.code() == StatusCode::InvalidInput);
}

TEST_CASE("lost odometry: views take over sooner, in the whole plugin") {
  const auto shareAfterOneView = [](TrackingState state) {
    PaperAttractor plugin;
    REQUIRE(configure(plugin, {{"first_views_ignored", std::int64_t{0}},
                               {"newest_ignored", std::int64_t{0}}})
                .isOk());
    step(plugin, motionOf({0, 0, 0}), novel(0));
    Motion motion = motionOf({20, 0, 0}, 1);
    motion.state = state;
    step(plugin, motion, familiar(0));
    return arrayOf(plugin, "grid.calibration")[2];
  };
  CHECK(shareAfterOneView(TrackingState::Tracking) == Approx(0.179).margin(0.001));
  CHECK(shareAfterOneView(TrackingState::Lost) == Approx(0.417).margin(0.001));
}

TEST_CASE("a familiar template that was never announced is learned, not trusted") {
  PaperAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  const Decision first = step(plugin, motionOf({0, 0, 0}), familiar(4000000000));
  CHECK(first.action == Action::CreateExperience);
  CHECK(arrayOf(plugin, "grid.injected")[2] == 0);
}
