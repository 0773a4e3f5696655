// SPDX-License-Identifier: BSD-3-Clause
// Steps along the path: their spacing, standing still, restarts, unknown scale.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "part_state.hpp"
#include "path_cost.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

Motion initialising() { return {}; }

Motion ahead(double metres, bool scale_known = true) {
  Motion motion;
  motion.state = TrackingState::Tracking;
  motion.T_previous_current.translation() << 0.6 * metres, 0, 0.8 * metres;
  motion.scale_known = scale_known;
  return motion;
}

std::string bytesOf(const PathSteps& steps) {
  return savedBytes([&](StateWriter& writer) { steps.save(writer); });
}

bool takes(PathSteps& steps, const std::string& bytes) {
  StateReader reader = readerOf(bytes);
  return steps.load(reader) && reader.complete();
}

}  // namespace

TEST_CASE("the first frame begins a pass, then each spacing is a step") {
  PathSteps steps(1, 20);
  const auto first = steps.move(initialising());
  REQUIRE(first);
  CHECK(first->begins_pass);
  CHECK(first->path == 0);
  CHECK(first->advance == 1);
  for (int i = 1; i <= 40; ++i) {
    const auto step = steps.move(ahead(0.25));
    CAPTURE(i);
    REQUIRE(step.has_value() == (i % 4 == 0));
    if (!step) continue;
    CHECK_FALSE(step->begins_pass);
    CHECK(step->path == Approx(0.25 * i));
    CHECK(step->advance == Approx(1));
  }
}

TEST_CASE("motions of a tenth of a spacing do not lose a step to rounding") {
  PathSteps steps(1, 20);
  steps.move(initialising());
  int made = 0;
  for (int i = 0; i < 1000; ++i) made += steps.move(ahead(0.1)) ? 1 : 0;
  CHECK(made == 100);
}

TEST_CASE("advance is what was driven since the step before, in spacings") {
  PathSteps steps(2, 20);
  steps.move(initialising());
  CHECK(steps.move(ahead(5))->advance == Approx(2.5));
  CHECK_FALSE(steps.move(ahead(1.9)));
  const auto step = steps.move(ahead(0.7));
  REQUIRE(step);
  CHECK(step->advance == Approx(1.3));
  CHECK(step->path == Approx(7.6));
  CHECK(steps.move(ahead(-2.2))->advance == Approx(1.1));  // backwards is driven as well
}

TEST_CASE("standing still adds nothing") {
  PathSteps steps(1, 20);
  steps.move(initialising());
  for (int i = 0; i < 100; ++i) REQUIRE_FALSE(steps.move(ahead(0)));
  for (int i = 0; i < 3; ++i) REQUIRE_FALSE(steps.move(ahead(0.3)));
  CHECK(steps.move(ahead(0.3))->path == Approx(1.2));
}

TEST_CASE("a restart begins a pass, beyond the gap; frames of one start are one") {
  PathSteps steps(1, 20);
  REQUIRE(steps.move(initialising())->begins_pass);
  CHECK_FALSE(steps.move(initialising()));  // still initialising
  CHECK_FALSE(steps.move(ahead(0.9)));
  const auto again = steps.move(initialising());
  REQUIRE(again);
  CHECK(again->begins_pass);
  CHECK(again->path == Approx(20.9));
  CHECK_FALSE(steps.move(initialising()));
  CHECK_FALSE(steps.move(ahead(0.5)));  // what was driven before does not count
  const auto next = steps.move(ahead(0.5));
  REQUIRE(next);
  CHECK_FALSE(next->begins_pass);
  CHECK(next->path == Approx(21.9));
}

TEST_CASE("a drive that begins without initialising begins a pass as well") {
  PathSteps steps(1, 20);
  REQUIRE(steps.move(ahead(3))->begins_pass);
  CHECK_FALSE(steps.move(ahead(0.5)));
}

TEST_CASE("while tracking is lost the predicted motion counts") {
  PathSteps steps(1, 20);
  steps.move(initialising());
  Motion lost = ahead(0.5);
  lost.state = TrackingState::Lost;
  CHECK_FALSE(steps.move(lost));
  const auto step = steps.move(lost);
  REQUIRE(step);
  CHECK(step->path == Approx(1));
  CHECK_FALSE(step->begins_pass);
}

TEST_CASE("in unknown units a mean motion is one spacing") {
  for (const double unit : {0.001, 1.0, 500.0}) {
    PathSteps steps(2, 20);
    steps.move(initialising());
    RandomStream random(1);
    int made = 0;
    double path = 0;
    for (int i = 0; i < 1000; ++i) {
      const auto step = steps.move(ahead(unit * random.uniform(0.5, 1.5), false));
      made += step ? 1 : 0;
      if (step) path = step->path;
    }
    CAPTURE(unit);
    CHECK(path == Approx(2000).epsilon(0.1));
    CHECK(made > 450);
    CHECK(made < 1000);
    for (int i = 0; i < 10; ++i) CHECK_FALSE(steps.move(ahead(0, false)));
  }
}

TEST_CASE("a step whose image could not be used is taken with the next frame") {
  PathSteps steps(1, 20);
  steps.postpone(*steps.move(initialising()));
  const auto first = steps.move(ahead(0.2));
  REQUIRE(first);
  CHECK(first->begins_pass);
  CHECK_FALSE(steps.move(ahead(0.9)));
  const auto step = steps.move(ahead(0.3));
  REQUIRE(step);
  steps.postpone(*step);
  const auto later = steps.move(ahead(0));  // even where it stands
  REQUIRE(later);
  CHECK(later->advance == Approx(1.2));
  CHECK(later->path == Approx(1.4));
  CHECK_FALSE(later->begins_pass);
  CHECK_FALSE(steps.move(ahead(0.9)));
}

TEST_CASE("loaded steps go on as the saved ones would, to the bit") {
  RandomStream random(2);
  PathSteps saved(1, 20);
  for (int i = 0; i < 200; ++i) {
    PathSteps loaded(1, 20);
    loaded.move(ahead(0.7));  // forgotten
    REQUIRE(takes(loaded, bytesOf(saved)));
    const Motion motion =
        random.below(20) == 0 ? initialising() : ahead(random.uniform(), random.below(3) == 0);
    const auto a = saved.move(motion);
    const auto b = loaded.move(motion);
    REQUIRE(a.has_value() == b.has_value());
    if (a) {
      CHECK(a->path == b->path);
      CHECK(a->advance == b->advance);
      CHECK(a->begins_pass == b->begins_pass);
      if (random.below(4) == 0) {
        saved.postpone(*a);
        loaded.postpone(*b);
      }
    }
    REQUIRE(bytesOf(saved) == bytesOf(loaded));
  }
}

TEST_CASE("lengths that are none are refused") {
  PathSteps steps(1, 20);
  steps.move(ahead(3, false));
  const std::string sound = bytesOf(steps);
  for (const double wild : {double{NAN}, double{INFINITY}, -1.0}) {
    for (const std::size_t at : {0U, 8U, 16U}) {
      PathSteps other(1, 20);
      CAPTURE(wild, at);
      CHECK_FALSE(takes(other, overwritten(sound, at, wild)));
    }
  }
  for (std::size_t length = 0; length < sound.size(); ++length) {
    PathSteps other(1, 20);
    CHECK_FALSE(takes(other, sound.substr(0, length)));
  }
}
