// SPDX-License-Identifier: BSD-3-Clause
// Lengths of two kinds in one map: metres, and the arbitrary units of a single camera.
#include "engine/scale_check.hpp"

#include <algorithm>

#include "pipeline/toy_stages.hpp"

using namespace tolman;
using namespace tolman::pipeline;
using tolman::test::Hooks;
using tolman::test::ToySystem;

namespace {

Motion motionOf(TrackingState state, bool scale_known) {
  Motion motion;
  motion.frame = 7;
  motion.state = state;
  motion.scale_known = scale_known;
  return motion;
}

Motion tracked(bool scale_known) { return motionOf(TrackingState::Tracking, scale_known); }

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

TEST_CASE("one kind of scale is none to tell, whatever frames without tracking say") {
  for (const bool known : {false, true}) {
    ScaleCheck check;
    for (const auto state : {TrackingState::Initialising, TrackingState::Tracking,
                             TrackingState::Lost, TrackingState::Initialising}) {
      const bool tells = state == TrackingState::Tracking;
      CHECK_FALSE(check.check(motionOf(state, tells ? known : !known)));
    }
    CHECK_FALSE(check.check(tracked(known)));
  }
}

TEST_CASE("a change of the scale within a session is told with both kinds") {
  ScaleCheck check;
  CHECK_FALSE(check.check(tracked(true)));
  const auto change = check.check(tracked(false));
  REQUIRE(change);
  CHECK_FALSE(change->ends_run);
  CHECK(
      change->text.starts_with("the lengths of this motion are in arbitrary units (scale_known "
                               "is false), those before in metres (scale_known is true)"));
  CHECK_FALSE(check.check(tracked(false)));  // each change is told once
  CHECK(check.check(tracked(true)));
}

TEST_CASE("a session with lengths of another kind than its map ends, and both are named") {
  ScaleCheck check;
  check.startFrom({true, "runs/monday"});
  CHECK_FALSE(check.check(motionOf(TrackingState::Initialising, false)));
  const auto change = check.check(tracked(false));
  REQUIRE(change);
  CHECK(change->ends_run);
  CHECK(change->text ==
        "frame 7: odometry gives lengths in arbitrary units (scale_known is false), and the map of "
        "the earlier session runs/monday has lengths in metres (scale_known is true); continue it "
        "with an odometry of the same kind, or begin a new map without --continue");
  ScaleCheck same;
  same.startFrom({false, "runs/monday"});
  CHECK_FALSE(same.check(tracked(false)));
}

TEST_CASE("a run with one scale is not warned of, one that changes is, up to ten times") {
  CHECK(warningsOf([](std::int64_t) { return true; }) == 0);
  CHECK(warningsOf([](std::int64_t) { return false; }) == 0);  // a single camera
  CHECK(warningsOf([](std::int64_t frame) { return frame == 0; }) == 0);
  CHECK(warningsOf([](std::int64_t frame) { return frame < 20; }) == 1);
  CHECK(warningsOf([](std::int64_t frame) { return frame % 2 == 0; }) == 10);
}

TEST_CASE("the map of an earlier session gets no motion of another scale, under any policy") {
  Hooks hooks;
  hooks.scale_known = [](std::int64_t) { return false; };
  ToySystem system(hooks);
  Chain chain({system.source, system.checked_odometry, system.place, system.cells, system.map},
              {.odometry = config::FailurePolicy::Skip}, system.diary);
  chain.continueMap({true, "runs/monday"});
  const auto result = drive(chain, {}, 2, system.flag);
  REQUIRE(result.failure);
  CHECK(result.failure->role == Role::Odometry);
  CHECK(result.failure->other_scale);
  CHECK(result.failure->status.message().starts_with("frame 1: odometry gives lengths in"));
  CHECK(system.diary.entries.size() == 1);  // the first frame has no motion
}
