// SPDX-License-Identifier: BSD-3-Clause
// Lengths of two kinds in one map: metres, and the arbitrary units of a single camera.
#include <algorithm>

#include "engine/toy_stages.hpp"

using namespace tolman;
using namespace tolman::engine;
using tolman::test::Hooks;
using tolman::test::ToySystem;

namespace {

/// The number of warnings about the scale, in a run whose odometry answers so.
std::ptrdiff_t warningsOf(const std::function<bool(std::int64_t)>& scale_known) {
  Hooks hooks;
  hooks.scale_known = scale_known;
  ToySystem system(hooks);
  const auto result = system.drive({}, 2);
  CHECK_FALSE(result.failure);
  CHECK(result.counters.frames == 30);
  return std::ranges::count_if(system.diary.events, [](const Event& event) {
    return event.level == LogLevel::Warning &&
           event.message.find("arbitrary units") != event.message.npos;
  });
}

}  // namespace

TEST_CASE("a run with one scale has no warning, one that changes has one at each change") {
  CHECK(warningsOf([](std::int64_t) { return true; }) == 0);
  CHECK(warningsOf([](std::int64_t) { return false; }) == 0);  // a single camera
  CHECK(warningsOf([](std::int64_t frame) { return frame == 0; }) == 0);
  CHECK(warningsOf([](std::int64_t frame) { return frame < 20; }) == 1);
  CHECK(warningsOf([](std::int64_t frame) { return frame % 2 == 0; }) == 28);
}

TEST_CASE("the map of an earlier session gets no motion of another scale, under any policy") {
  Hooks hooks;
  hooks.scale_known = [](std::int64_t) { return false; };
  ToySystem system(hooks);
  Chain chain({system.source, system.checked_odometry, system.place, system.cells, system.map},
              {config::FailurePolicy::Stop, config::FailurePolicy::Skip}, system.diary);
  chain.continueMap({true, "runs/monday"});
  const auto result = drive(chain, {}, 2, system.flag);
  REQUIRE(result.failure);
  CHECK(result.failure->stage == enumName(Role::Odometry));
  CHECK(result.failure->kind == engine::FailureKind::Continuation);
  CHECK(result.failure->message.starts_with("frame 1: odometry gives lengths in"));
  CHECK(system.diary.entries.size() == 1);  // the first frame has no motion
}
