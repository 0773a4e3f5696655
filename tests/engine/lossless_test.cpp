// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <thread>

#include "engine/toy_stages.hpp"

using namespace tolman;
using tolman::test::Hooks;
using tolman::test::ToySystem;

namespace {

/// Sleeps a little, differently for each stage and frame, to shake the order of things.
auto shaken(std::uint64_t salt) {
  return [salt](std::int64_t frame) {
    const auto draw = RandomStream(salt * 1000 + static_cast<std::uint64_t>(frame)).below(800);
    std::this_thread::sleep_for(std::chrono::microseconds(draw));
    return Status::ok();
  };
}

std::vector<test::Diary::Entry> drive(int threads, bool place_needs_motion) {
  Hooks hooks;
  hooks.frames = 60;
  hooks.place_needs_motion = place_needs_motion;
  hooks.source = shaken(1);
  hooks.odometry = shaken(2);
  hooks.place = shaken(3);
  hooks.cells = shaken(4);
  ToySystem system(hooks);
  const auto result = system.drive({}, threads);
  CHECK_FALSE(result.failure);
  CHECK(result.counters.frames == 60);
  CHECK(result.counters.templates == 60);
  CHECK(hooks.finished == 4);
  CHECK(system.diary.revisions == 1);
  return system.diary.entries;
}

}  // namespace

TEST_CASE("every frame is published once, in order, the same for any number of threads") {
  for (const bool place_needs_motion : {false, true}) {
    const auto one = drive(1, place_needs_motion);
    REQUIRE(one.size() == 60);
    double state = 0;
    double z = 0;
    for (std::size_t k = 0; k < one.size(); ++k) {  // the oracle: a plain loop
      state = 0.9 * state + static_cast<double>(k);
      z += state;
      CHECK(one[k].frame == static_cast<std::int64_t>(k));
      CHECK(one[k].v == state);
      CHECK(one[k].z == 1e-6 * z);
      CHECK(one[k].score == (place_needs_motion ? state : 0));
    }
    CHECK(drive(2, place_needs_motion) == one);
    CHECK(drive(4, place_needs_motion) == one);
  }
}

TEST_CASE("the time that each stage takes to finish is measured") {
  Hooks hooks;
  hooks.frames = 2;
  hooks.map_finish = [] { std::this_thread::sleep_for(std::chrono::milliseconds(20)); };
  ToySystem system(hooks);
  const StageTimes times = system.drive({}, 1).finish_times_ns;
  const auto of = [&](Role role) { return times[static_cast<std::size_t>(role)]; };
  CHECK(of(Role::Map) >= 20'000'000);  // a sleep is never shorter
  CHECK(of(Role::Odometry) > 0);
  CHECK(of(Role::Source) == 0);  // has none
}

TEST_CASE("odometry and place recognition of one frame run side by side") {
  Hooks hooks;
  hooks.frames = 1;
  std::atomic<int> inside = 0;
  const auto meet = [&](std::int64_t) {  // each waits for the other; gives up after a minute
    ++inside;
    for (int i = 0; i < 60000 && inside < 2; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return inside == 2 ? Status::ok() : Status::failed("alone");
  };
  hooks.odometry = meet;
  hooks.place = meet;
  ToySystem system(hooks);
  CHECK_FALSE(system.drive({}, 2).failure);
}

TEST_CASE("no more frames are in flight than the queue allows") {
  Hooks hooks;
  hooks.frames = 200;
  std::atomic<std::int64_t> given = 0;
  std::atomic<std::int64_t> most = 0;
  hooks.source = [&](std::int64_t) {
    ++given;
    return Status::ok();
  };
  hooks.map = [&](std::int64_t frame) {
    most = std::max<std::int64_t>(most, given - frame);
    return Status::ok();
  };
  ToySystem system(hooks);
  config::PipelineSettings settings;
  settings.queue = 4;
  CHECK_FALSE(system.drive(settings, 4).failure);
  CHECK(most <= 6);  // four in flight, one waiting before them, one being made
}

TEST_CASE("cancellation ends the run early, and what was done is finished") {
  Hooks hooks;
  hooks.frames = 1'000'000;
  ToySystem system(hooks);
  hooks.map = [&](std::int64_t frame) {
    if (frame == 10) system.flag.set = true;
    return Status::ok();
  };
  const auto result = system.drive({}, 2);
  CHECK(result.interrupted);
  CHECK_FALSE(result.failure);
  CHECK(result.counters.frames >= 11);
  CHECK(static_cast<std::int64_t>(system.diary.entries.size()) == result.counters.frames);
  CHECK(hooks.finished == 4);
}

TEST_CASE("a source that notices the interruption itself has not failed") {
  for (const auto mode : {config::PipelineMode::Lossless, config::PipelineMode::Realtime}) {
    Hooks hooks;
    ToySystem system(hooks);
    hooks.source = [&](std::int64_t frame) -> Status {
      system.flag.set = frame == 3;
      return frame == 3 ? Status{StatusCode::Cancelled, "reading was cancelled"} : Status::ok();
    };
    config::PipelineSettings settings;
    settings.mode = mode;
    const auto result = system.drive(settings, 2);
    CHECK(result.interrupted);
    CHECK_FALSE(result.failure);
    CHECK(result.counters.frames == 3);
    system.flag.set = false;
    Hooks others;
    ToySystem not_interrupted(others);
    others.source = [](std::int64_t) { return Status{StatusCode::Cancelled, "not asked for"}; };
    CHECK(not_interrupted.drive(settings, 2).failure);
  }
}

TEST_CASE("order holds when the stages are so quick that threads overtake one another") {
  Hooks hooks;
  hooks.frames = 20'000;
  ToySystem system(hooks);
  REQUIRE_FALSE(system.drive({}, 4).failure);
  REQUIRE(system.diary.entries.size() == 20'000);
  for (std::int64_t k = 0; k < 20'000; ++k) {
    const auto& entry = system.diary.entries[static_cast<std::size_t>(k)];
    REQUIRE(entry.frame == k);
    REQUIRE(entry.template_id == k);
  }
}
