// SPDX-License-Identifier: BSD-3-Clause
// When a new experience or a loop is due: by distance, turn or novelty, compared with a plain sum
// of the driven distance.
#include <catch2/catch.hpp>
#include <experience_log.hpp>

#include "tolman/context.hpp"

using namespace tolman;

namespace {

void drive(ExperienceLog& log, double metres, double step = 0.25) {
  for (double done = 0; done < metres - 1e-9; done += step) log.advance(fromPlanar({step, 0, 0}));
}

}  // namespace

TEST_CASE("the first experience is due at once, the next by way, by turn, or by a novel view") {
  ExperienceLog log{{}};
  CHECK(log.current() == -1);
  CHECK(log.wantsNew(false));
  CHECK(log.create() == 0);
  CHECK_FALSE(log.wantsNew(false));
  CHECK_FALSE(log.wantsNew(true));  // on the spot there is nothing new
  drive(log, 0.75);
  CHECK_FALSE(log.wantsNew(true));
  drive(log, 0.25);
  CHECK(log.wantsNew(true));
  CHECK_FALSE(log.wantsNew(false));
  drive(log, 3.75);
  CHECK_FALSE(log.wantsNew(false));
  drive(log, 0.25);
  CHECK(log.wantsNew(false));
  CHECK(log.create() == 1);
  log.advance(fromPlanar({0.1, 0, 0.49}));
  CHECK_FALSE(log.wantsNew(false));
  log.advance(fromPlanar({0.1, 0, 0.02}));
  CHECK(log.wantsNew(false));
}

TEST_CASE("a way that returns counts by where it ends; one that turns both ways by the sum") {
  ExperienceLog log{{}};
  log.create();
  for (int i = 0; i < 40; ++i) log.advance(fromPlanar({i % 2 == 0 ? 1.0 : -1.0, 0, 0}));
  CHECK_FALSE(log.wantsNew(false));
  for (int i = 0; i < 40; ++i) log.advance(fromPlanar({0, 0, i % 2 == 0 ? 0.3 : -0.3}));
  CHECK_FALSE(log.wantsNew(false));
}

TEST_CASE("loops: not to here, not soon after leaving, not one right after the other") {
  ExperienceLog log{{}};
  log.create();  // 0, left at 10 m
  drive(log, 10);
  log.create();  // 1
  CHECK_FALSE(log.allowsLoopTo(1));
  drive(log, 29.75);
  CHECK_FALSE(log.allowsLoopTo(0));
  drive(log, 0.25);
  CHECK(log.allowsLoopTo(0));
  CHECK_FALSE(log.allowsLoopTo(1));  // still there
  log.closeLoopTo(0, fromPlanar({1, 2, 0.3}));
  CHECK(log.current() == 0);
  CHECK(toPlanar(log.fromCurrent()).y == Approx(2));
  drive(log, 31);
  CHECK(log.allowsLoopTo(1));
  log.closeLoopTo(1, {});
  drive(log, 4.75);
  CHECK_FALSE(log.allowsLoopTo(0));  // 5 m between loops
}

TEST_CASE("a loop is no new experience: the distance to the next one counts on") {
  ExperienceLog log{{}};
  log.create();
  drive(log, 40);
  log.create();
  drive(log, 35);
  REQUIRE(log.allowsLoopTo(0));
  log.closeLoopTo(0, Eigen::Isometry3d::Identity());
  CHECK(log.wantsNew(false));
  ExperienceLog papers{{.from_newest = false}};  // counts from the experience it is at
  papers.create();
  drive(papers, 40);
  papers.create();
  drive(papers, 35);
  papers.closeLoopTo(0, Eigen::Isometry3d::Identity());
  CHECK_FALSE(papers.wantsNew(false));
}

TEST_CASE("carried away: a new experience is due, and loops to all are allowed at once") {
  ExperienceLog log{{}};
  log.startPart();  // before the first experience it has no effect
  CHECK(log.current() == -1);
  for (int i = 0; i < 3; ++i) {
    log.create();
    drive(log, 6);
  }
  log.startPart();
  CHECK(log.wantsNew(false));
  for (std::int64_t id = 0; id < 3; ++id) CHECK(log.allowsLoopTo(id));
  CHECK(log.create() == 3);
  CHECK_FALSE(log.wantsNew(false));
}

TEST_CASE("a restored log answers as the first, over any drive") {
  RandomStream random(12);
  ExperienceLog log{{}};
  std::int64_t made = 0;
  int loops = 0;
  for (int i = 0; i < 4000; ++i) {
    log.advance(fromPlanar({random.uniform(0, 0.6), 0, random.uniform(-0.05, 0.06)}));
    ExperienceLog copy{{}};
    copy.restore(log.state());
    const bool novel = random.below(10) == 0;
    REQUIRE(copy.wantsNew(novel) == log.wantsNew(novel));
    REQUIRE(copy.current() == log.current());
    if (log.wantsNew(novel)) {
      REQUIRE(log.create() == made++);
      continue;
    }
    const auto id = static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(made)));
    REQUIRE(copy.allowsLoopTo(id) == log.allowsLoopTo(id));
    if (random.below(40) == 0 && log.allowsLoopTo(id)) {
      log.closeLoopTo(id, fromPlanar({random.normal(), 0, 0}));
      ++loops;
    }
  }
  CHECK(loops > 10);
  CHECK(made > 200);
}
