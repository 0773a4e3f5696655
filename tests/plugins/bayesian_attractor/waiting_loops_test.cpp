// SPDX-License-Identifier: BSD-3-Clause
// Loops are kept until their bump wins: their spacing, their order, and removal with the bump.
#include "waiting_loops.hpp"

#include <catch2/catch.hpp>

using namespace tolman;
using namespace tolman::bayesian_attractor;

namespace {

WaitingLoop waitingLoop(std::int64_t bump, double travel, std::int64_t frame) {
  return {bump, travel, {frame, 0, Eigen::Isometry3d::Identity(), Matrix6d::Identity()}};
}

std::vector<std::int64_t> framesOf(const std::vector<EarlierLoop>& loops) {
  std::vector<std::int64_t> frames;
  for (const EarlierLoop& loop : loops) frames.push_back(loop.frame);
  return frames;
}

CalibrationBump bump(std::int64_t id) {
  CalibrationBump bump;
  bump.id = id;
  return bump;
}

}  // namespace

TEST_CASE("loops of one bump keep their distance, those of another do not matter") {
  WaitingLoops waiting(5);
  waiting.add(waitingLoop(0, 10, 1));
  waiting.add(waitingLoop(0, 14.9, 2));
  waiting.add(waitingLoop(1, 14.9, 2));
  waiting.add(waitingLoop(0, 15, 3));
  CHECK(framesOf(waiting.of(0, 100)) == std::vector<std::int64_t>{1, 3});
  CHECK(framesOf(waiting.of(1, 100)) == std::vector<std::int64_t>{2});
  CHECK(waiting.of(2, 100).empty());
}

TEST_CASE("a waiting loop near the one that is closed now is not reported") {
  WaitingLoops waiting(5);
  waiting.add(waitingLoop(0, 10, 1));
  waiting.add(waitingLoop(0, 15, 2));
  CHECK(framesOf(waiting.of(0, 19)) == std::vector<std::int64_t>{1});
  CHECK(framesOf(waiting.of(0, 20)) == std::vector<std::int64_t>{1, 2});
}

TEST_CASE("loops are forgotten with their bump") {
  WaitingLoops waiting(5);
  waiting.add(waitingLoop(0, 10, 1));
  waiting.add(waitingLoop(3, 10, 1));
  waiting.keep(std::vector{bump(2), bump(3)});
  REQUIRE(waiting.list().size() == 1);
  CHECK(waiting.list()[0].bump == 3);
  waiting.keep({});
  CHECK(waiting.list().empty());
}
