// SPDX-License-Identifier: BSD-3-Clause
// When an experience is due, and when a loop link is.
#include "experience_log.hpp"

#include <catch2/catch.hpp>
#include <numbers>

using namespace tolman;
using namespace tolman::paper_attractor;

namespace {
void drive(ExperienceLog& log, double metres) { log.advance(fromPlanar({metres, 0, 0})); }
}  // namespace

TEST_CASE("the first frame makes the first experience") {
  ExperienceLog log({});
  CHECK(log.current() == -1);
  CHECK(log.wantsNew(false));
  CHECK(log.create() == 0);
  CHECK_FALSE(log.wantsNew(false));
  CHECK_FALSE(log.wantsNew(true));  // a novel view at the same place
}

TEST_CASE("experiences by distance, turn and novelty") {
  ExperienceLog log({.spacing = 5, .turn = 0.5, .novel_spacing = 1});
  log.create();
  drive(log, 0.9);
  CHECK_FALSE(log.wantsNew(true));
  drive(log, 0.2);
  CHECK(log.wantsNew(true));
  CHECK_FALSE(log.wantsNew(false));
  drive(log, 4);
  CHECK(log.wantsNew(false));
  CHECK(log.create() == 1);
  log.advance(fromPlanar({0, 0, -0.49}));
  CHECK_FALSE(log.wantsNew(false));
  log.advance(fromPlanar({0, 0, -0.02}));
  CHECK(log.wantsNew(false));
}

TEST_CASE("loops: not here, not just left, not one after the other") {
  ExperienceLog log({.loop_minimum_travel = 30, .loop_spacing = 5});
  for (int id = 0; id < 10; ++id) {
    log.create();
    drive(log, 10);
  }  // experience id was left at 10 (id + 1) m; now at 100 m, still at experience 9
  CHECK_FALSE(log.allowsLoopTo(9));
  CHECK_FALSE(log.allowsLoopTo(7));  // left 20 m ago
  CHECK(log.allowsLoopTo(6));        // left 30 m ago
  log.closeLoopTo(2, fromPlanar({0, 1, 0.1}));
  CHECK(log.current() == 2);
  CHECK(toPlanar(log.fromCurrent()).y == Approx(1));
  drive(log, 4);
  CHECK_FALSE(log.allowsLoopTo(3));  // 4 m after the last link
  drive(log, 2);
  CHECK(log.allowsLoopTo(3));
  CHECK_FALSE(log.allowsLoopTo(9));  // left 6 m ago, when the loop was closed
}
