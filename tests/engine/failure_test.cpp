// SPDX-License-Identifier: BSD-3-Clause
// Effect of a failing stage on a run, for each policy.
#include <algorithm>
#include <chrono>
#include <thread>

#include "engine/toy_stages.hpp"

using namespace tolman;
using config::FailurePolicy;
using tolman::test::Hooks;
using tolman::test::ToySystem;

namespace {

auto failAt(std::int64_t bad) {
  return
      [bad](std::int64_t frame) { return frame == bad ? Status::failed("broken") : Status::ok(); };
}

}  // namespace

TEST_CASE("stop: exactly the frames before the failure are published, for any stage and threads") {
  const std::array stages = {
      std::pair{&Hooks::odometry, Role::Odometry}, std::pair{&Hooks::place, Role::Place},
      std::pair{&Hooks::cells, Role::Cells}, std::pair{&Hooks::map, Role::Map}};
  for (const int threads : {1, 2, 4}) {
    for (const auto& [stage, role] : stages) {
      Hooks hooks;
      hooks.*stage = failAt(7);
      ToySystem system(hooks);
      const auto result = system.drive({}, threads);
      REQUIRE(result.failure);
      CHECK(result.failure->stage == enumName(role));
      CHECK(result.failure->message.find("frame 7: broken") != std::string::npos);
      CHECK(system.diary.entries.size() == 7);
      CHECK(result.counters.frames == 7);
      CHECK(hooks.finished == 4);
      REQUIRE(system.diary.events.size() == 1);
      CHECK(system.diary.events[0].level == LogLevel::Error);
      CHECK(system.diary.events[0].frame == 7);
    }
  }
}

TEST_CASE("a failing source ends the run after all frames that it gave") {
  Hooks hooks;
  hooks.source = failAt(5);
  ToySystem system(hooks);
  const auto result = system.drive({}, 2);
  REQUIRE(result.failure);
  CHECK(result.failure->stage == enumName(Role::Source));
  CHECK(result.failure->message == "source (toy), next, frame 5: broken");
  CHECK(system.diary.entries.size() == 5);
}

TEST_CASE("skip: a predicted motion stands in, marked lost, and the run goes on") {
  Hooks hooks;
  hooks.odometry = failAt(7);
  ToySystem system(hooks);
  const auto result = system.drive({}, 2, {FailurePolicy::Stop, FailurePolicy::Skip});
  CHECK_FALSE(result.failure);
  CHECK(result.counters.frames == 30);
  CHECK(result.counters.skipped == 1);
  CHECK(result.counters.lost == 1);
  CHECK_FALSE(result.counters.lost_at_end);
  CHECK(system.diary.entries[7].lost);
  CHECK_FALSE(system.diary.entries[8].lost);
}

TEST_CASE("skip: place, cells and map answer nothing new for the frame") {
  for (auto stage : {&Hooks::place, &Hooks::cells, &Hooks::map}) {
    Hooks hooks;
    hooks.*stage = failAt(3);
    ToySystem system(hooks);
    const auto result = system.drive({}, 2,
                                     {FailurePolicy::Skip, FailurePolicy::Skip, FailurePolicy::Skip,
                                      FailurePolicy::Skip, FailurePolicy::Skip});
    CHECK_FALSE(result.failure);
    CHECK(result.counters.frames == 30);
    CHECK(result.counters.skipped == 1);
    CHECK(system.diary.events.at(0).message.find("frame skipped") != std::string::npos);
  }
}

TEST_CASE("a stage that fails at every frame skips every frame") {
  Hooks hooks;
  hooks.cells = [](std::int64_t) { return Status::failed("broken"); };
  hooks.map_finish = [] { throw std::runtime_error("broken"); };
  ToySystem system(hooks);
  const auto result = system.drive({}, 2,
                                   {FailurePolicy::Stop, FailurePolicy::Stop, FailurePolicy::Stop,
                                    FailurePolicy::Skip, FailurePolicy::Skip});
  CHECK_FALSE(result.failure);
  CHECK(result.counters.frames == 30);
  CHECK(result.counters.skipped == 30);
}

TEST_CASE("a listener that fails (a full disk) stops the run with its own status") {
  Hooks hooks;
  ToySystem system(hooks);
  system.diary.on_frame = [](std::int64_t frame) {
    // Slow enough that the map has processed the frames after this one.
    if (frame == 4) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return frame == 4 ? Status::failed("broken") : Status::ok();
  };
  const auto result = system.drive({}, 2);
  REQUIRE(result.failure);
  CHECK(result.failure->stage == enumName(Role::Observer));
  CHECK(result.failure->message == "broken");
  // Frames that the map processed meanwhile are published without a gap; no new ones are started.
  const std::size_t count = system.diary.entries.size();
  CHECK(count >= 5);
  CHECK(count < 15);
  CHECK(system.diary.entries.back().frame == static_cast<std::int64_t>(count) - 1);
}

TEST_CASE("a map without poses of frames that it accepted stops the run, or is reported") {
  Hooks hooks;
  hooks.pose_of = [](std::int64_t frame) {
    return frame == 3 || frame == 4 ? Status::invalidParameter("not seen") : Status::ok();
  };
  ToySystem stopping(hooks);
  const auto stopped = stopping.drive({}, 2);
  REQUIRE(stopped.failure);
  CHECK(stopped.failure->stage == enumName(Role::Map));
  CHECK(stopped.failure->message ==
        "poseOf() has no pose for 2 frames that update() accepted; the trajectories lack them");
  ToySystem skipping(hooks);
  const auto policy = FailurePolicy::Skip;
  CHECK_FALSE(skipping.drive({}, 2, {policy, policy, policy, policy, policy}).failure);
  CHECK(skipping.diary.events.back().message.find("no pose for 2 frames") != std::string::npos);
}

TEST_CASE("after a failure no graph with a frame without a record is published") {
  Hooks hooks;
  hooks.map_grows = true;  // an experience a frame
  bool fails = true;
  SECTION("a graph that is wrong once") {
    hooks.graph = [&](std::int64_t experiences) {
      if (experiences < 6 || !std::exchange(fails, false)) return Status::ok();
      return Status::failed("torn");
    };
  }
  SECTION("an update that fails once it has made the experience") {
    hooks.map = [](std::int64_t frame) {
      return frame == 5 ? Status::failed("torn") : Status::ok();
    };
  }
  ToySystem system(hooks);
  const auto result = system.drive({}, 2);
  REQUIRE(result.failure);
  CHECK(result.failure->stage == enumName(Role::Map));
  CHECK_THAT(result.failure->message, Catch::Contains("torn"));
  CHECK(system.diary.entries.back().frame == 4);
  CHECK(system.diary.graphs.back().second == 5);
  CHECK(system.diary.final_size == 0);  // the graph has frame 5
}

TEST_CASE("after a failure of another stage the map of the earlier frames is published") {
  Hooks hooks;
  hooks.map_grows = true;
  hooks.cells = [](std::int64_t frame) {
    return frame == 5 ? Status::failed("torn") : Status::ok();
  };
  ToySystem system(hooks);
  REQUIRE(system.drive({}, 2).failure);
  CHECK(system.diary.final_size == 5);
}

TEST_CASE("impossible motions are counted and reported") {
  Hooks hooks;
  hooks.step_m = 1;  // 1000 m/s
  ToySystem system(hooks);
  const auto result = system.drive({}, 2);
  CHECK(result.counters.impossible == 29);
  const auto reported = std::ranges::count_if(system.diary.events, [](const auto& event) {
    return event.message.find("has a speed of 1000 m/s") != std::string::npos;
  });
  CHECK(reported == 29);
}
