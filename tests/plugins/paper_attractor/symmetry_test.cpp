// SPDX-License-Identifier: BSD-3-Clause
// The mirrored drive has the same experiences and loops, with mirrored headings. Template numbers
// have no effect.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::paper_attractor;
using namespace tolman::paper_attractor::test;

namespace {

struct Input {
  PlanarPose step;
  PlaceObservation seen;
};

/// Three laps of a round course of 60 views, noisy; from the second lap on the views are known.
std::vector<Input> course(std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Input> drive;
  for (int k = 0; k < 180; ++k) {
    const int place = k % 60;
    drive.push_back({{2.2 + 0.02 * random.normal(), 0.02 * random.normal(),
                      2 * std::numbers::pi / 60 + 0.002 * random.normal()},
                     k < 60 ? novel(place) : familiar(place, 0.02 * random.normal())});
  }
  return drive;
}

std::vector<Decision> decide(const std::vector<Input>& drive) {
  PaperAttractor plugin;
  REQUIRE(configure(plugin, {}).isOk());
  std::vector<Decision> decisions;
  for (const Input& input : drive) {
    const auto frame = static_cast<std::int64_t>(decisions.size());
    decisions.push_back(step(plugin, motionOf(input.step, frame), input.seen));
  }
  return decisions;
}

}  // namespace

TEST_CASE("a mirrored drive is decided alike, with mirrored headings") {
  int loops = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const std::vector<Input> drive = course(seed);
    std::vector<Input> other = drive;
    for (Input& input : other) {
      input.step = {input.step.x, -input.step.y, -input.step.theta};
      input.seen.relative_yaw = -input.seen.relative_yaw;
    }
    const std::vector<Decision> a = decide(drive);
    const std::vector<Decision> b = decide(other);
    for (std::size_t k = 0; k < a.size(); ++k) {
      CAPTURE(seed, k);
      REQUIRE(a[k].action == b[k].action);
      REQUIRE(a[k].experience == b[k].experience);
      REQUIRE(a[k].confidence == Approx(b[k].confidence).margin(1e-5));
      REQUIRE(a[k].relative_yaw == Approx(-b[k].relative_yaw).margin(1e-5));
      REQUIRE(std::cos(a[k].heading) == Approx(std::cos(b[k].heading)).margin(1e-4));
      REQUIRE(std::sin(a[k].heading) == Approx(-std::sin(b[k].heading)).margin(1e-4));
      loops += a[k].action == Action::CloseLoop;
    }
  }
  CHECK(loops > 10);
}

TEST_CASE("templates may have any numbers that grow") {
  const std::vector<Input> drive = course(7);
  std::vector<Input> other = drive;
  for (Input& input : other) input.seen.template_id = 5 * input.seen.template_id + 2;
  const std::vector<Decision> a = decide(drive);
  const std::vector<Decision> b = decide(other);
  for (std::size_t k = 0; k < a.size(); ++k) {
    REQUIRE(a[k].action == b[k].action);
    REQUIRE(a[k].experience == b[k].experience);
  }
}
