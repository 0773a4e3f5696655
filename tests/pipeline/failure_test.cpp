// SPDX-License-Identifier: BSD-3-Clause
// What one failing stage does to a run, by policy.
#include "pipeline/toy_stages.hpp"

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

TEST_CASE("stop: exactly the frames before the failure are told, for any stage and thread count") {
  for (const int threads : {1, 2, 4}) {
    for (auto stage : {&Hooks::odometry, &Hooks::place, &Hooks::cells, &Hooks::map}) {
      Hooks hooks;
      hooks.*stage = failAt(7);
      ToySystem system(hooks);
      const auto outcome = system.run({}, threads);
      CHECK(outcome.status.message().find("frame 7: broken") != std::string::npos);
      CHECK(system.diary.entries.size() == 7);
      CHECK(outcome.counters.frames == 7);
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
  const auto outcome = system.run({}, 2);
  CHECK(outcome.status.message() == "source (toy), next, frame 5: broken");
  CHECK(system.diary.entries.size() == 5);
}

TEST_CASE("skip: a predicted motion stands in, marked lost, and the run goes on") {
  Hooks hooks;
  hooks.odometry = failAt(7);
  ToySystem system(hooks);
  const auto outcome = system.run({}, 2, {.odometry = FailurePolicy::Skip});
  CHECK(outcome.status.isOk());
  CHECK(outcome.counters.frames == 30);
  CHECK(outcome.counters.skipped == 1);
  CHECK(outcome.counters.lost == 1);
  CHECK_FALSE(outcome.counters.lost_at_end);
  CHECK(system.diary.entries[7].lost);
  CHECK_FALSE(system.diary.entries[8].lost);
}

TEST_CASE("skip: place, cells and map answer nothing new for the frame") {
  for (auto stage : {&Hooks::place, &Hooks::cells, &Hooks::map}) {
    Hooks hooks;
    hooks.*stage = failAt(3);
    ToySystem system(hooks);
    const auto outcome = system.run(
        {}, 2,
        {FailurePolicy::Skip, FailurePolicy::Skip, FailurePolicy::Skip, FailurePolicy::Skip});
    CHECK(outcome.status.isOk());
    CHECK(outcome.counters.frames == 30);
    CHECK(outcome.counters.skipped == 1);
    CHECK(system.diary.events.at(0).message.find("frame skipped") != std::string::npos);
  }
}

TEST_CASE("a listener that fails (a full disk) stops the run with its own status") {
  Hooks hooks;
  ToySystem system(hooks);
  system.diary.on_frame = failAt(4);
  const auto outcome = system.run({}, 2);
  CHECK(outcome.status.message() == "broken");
  CHECK(system.diary.entries.size() == 5);
}
