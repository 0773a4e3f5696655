// SPDX-License-Identifier: BSD-3-Clause
// Decisions are invariant: the mirrored drive, the same drive at a later time, and other template
// numbers give the same decisions.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;
using namespace tolman::bayesian_attractor::test;

namespace {

struct Input {
  PlanarPose step;
  PlaceObservation seen;
};

/// Two and a half laps of an uneven round course, noisy, with measured views, views without a pose,
/// and look-alikes.
std::vector<Input> course(std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Input> drive;
  for (int k = 0; k < 125; ++k) {
    const int place = k % 50;
    Input input;
    input.step = {
        2.5 + 0.5 * std::sin(0.4 * place) + 0.01 * random.normal(), 0.05 * random.normal(),
        2 * std::numbers::pi / 50 + 0.2 * std::sin(1.1 * place) + 0.002 * random.normal()};
    if (k < 50) {
      input.seen = novel(place);
    } else if (random.below(4) == 0) {
      input.seen = measured(static_cast<std::int64_t>(random.below(50)));  // a look-alike
    } else {
      const PlanarPose offset = {0.2 * random.normal(), 0.2 * random.normal(),
                                 0.02 * random.normal()};
      input.seen = random.below(5) == 0 ? familiar(place, offset.theta) : measured(place, offset);
    }
    drive.push_back(input);
  }
  return drive;
}

std::vector<Decision> decide(const std::vector<Input>& drive, std::int64_t first_frame = 0) {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  std::vector<Decision> decisions;
  for (std::size_t k = 0; k < drive.size(); ++k) {
    const auto frame = first_frame + static_cast<std::int64_t>(k);
    decisions.push_back(step(plugin, motionOf(drive[k].step, frame), drive[k].seen));
  }
  return decisions;
}

PlanarPose mirrored(const PlanarPose& pose) { return {pose.x, -pose.y, -pose.theta}; }

int loopsIn(const std::vector<Decision>& decisions) {
  int loops = 0;
  for (const Decision& d : decisions) loops += d.action == Action::CloseLoop;
  return loops;
}

}  // namespace

TEST_CASE("a drive in a mirror has the same experiences and loops, and mirrored headings") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const std::vector<Input> drive = course(seed);
    std::vector<Input> other = drive;
    for (Input& input : other) {
      input.step = mirrored(input.step);
      input.seen.relative_yaw = -input.seen.relative_yaw;
      input.seen.T_template_current = fromPlanar(mirrored(toPlanar(input.seen.T_template_current)));
    }
    const std::vector<Decision> a = decide(drive);
    const std::vector<Decision> b = decide(other);
    CHECK(loopsIn(a) >= 3);
    for (std::size_t k = 0; k < a.size(); ++k) {
      CAPTURE(seed, k);
      REQUIRE(a[k].action == b[k].action);
      REQUIRE(a[k].experience == b[k].experience);
      REQUIRE(a[k].confidence == Approx(b[k].confidence).margin(1e-6));
      REQUIRE(std::cos(a[k].heading) == Approx(std::cos(b[k].heading)).margin(1e-6));
      REQUIRE(std::sin(a[k].heading) == Approx(-std::sin(b[k].heading)).margin(1e-6));
      REQUIRE(a[k].earlier.size() == b[k].earlier.size());
      const PlanarPose here = toPlanar(a[k].T_experience_current);
      const PlanarPose there = mirrored(toPlanar(b[k].T_experience_current));
      REQUIRE(here.x == Approx(there.x).margin(1e-6));
      REQUIRE(here.y == Approx(there.y).margin(1e-6));
    }
  }
}

TEST_CASE("a drive that begins at a later frame is decided alike") {
  const std::vector<Input> drive = course(7);
  const std::vector<Decision> a = decide(drive);
  const std::vector<Decision> b = decide(drive, 100'000);
  for (std::size_t k = 0; k < a.size(); ++k) {
    REQUIRE(a[k].action == b[k].action);
    REQUIRE(a[k].experience == b[k].experience);
    REQUIRE(a[k].T_experience_current.matrix() == b[k].T_experience_current.matrix());
    REQUIRE(b[k].frame == a[k].frame + 100'000);
    REQUIRE(a[k].earlier.size() == b[k].earlier.size());
    for (std::size_t i = 0; i < a[k].earlier.size(); ++i) {
      REQUIRE(b[k].earlier[i].frame == a[k].earlier[i].frame + 100'000);
    }
  }
}

TEST_CASE("templates may have any numbers, as long as they are different") {
  const std::vector<Input> drive = course(8);
  std::vector<Input> other = drive;
  for (Input& input : other) input.seen.template_id = 3 * input.seen.template_id + 11;
  const std::vector<Decision> a = decide(drive);
  const std::vector<Decision> b = decide(other);
  CHECK(loopsIn(a) >= 3);
  for (std::size_t k = 0; k < a.size(); ++k) {
    REQUIRE(a[k].action == b[k].action);
    REQUIRE(a[k].experience == b[k].experience);
    REQUIRE(a[k].confidence == b[k].confidence);
  }
}
