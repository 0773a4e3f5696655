// SPDX-License-Identifier: BSD-3-Clause
// Checkpoints: the states of all stages after one frame, without stopping the pipeline.
#include <algorithm>

#include "engine/chain.hpp"
#include "engine/toy_stages.hpp"

using namespace tolman;
using namespace tolman::test;

namespace {

const config::PipelineSettings kLossless;

/// Brings fresh stages to a checkpoint, drives the rest, and returns what was published.
std::vector<Diary::Entry> resumed(Hooks& hooks, const engine::Checkpoint& checkpoint, int threads) {
  ToySystem system(hooks);
  engine::ResumePoint point{checkpoint, {}, {}, {}};
  for (std::int64_t frame = 0; frame <= checkpoint.frame; ++frame) {
    Frame image;
    REQUIRE(system.source.next(image).isOk());
    point.motion = {};
    REQUIRE(system.odometry.track(image, point.motion).isOk());
  }
  point.decision.frame = point.map.frame = checkpoint.frame;
  REQUIRE(system.place.instance().load(checkpoint.states.at(Role::Place)).isOk());
  REQUIRE(system.cells.instance().load(checkpoint.states.at(Role::Cells)).isOk());
  REQUIRE(system.map.instance().load(checkpoint.states.at(Role::Map)).isOk());
  system.place.resetChecks(-1);
  system.cells.resetChecks(1);
  engine::Chain chain(
      {system.source, system.checked_odometry, system.place, system.cells, system.map}, {},
      system.diary);
  chain.resume(point);
  const auto result = engine::drive(chain, kLossless, threads, system.flag);
  CHECK_FALSE(result.failure);
  CHECK(result.counters.frames == hooks.frames);
  CHECK(result.counters.templates == hooks.frames);
  return system.diary.entries;
}

}  // namespace

TEST_CASE("from any checkpoint the rest of the run is as without an interruption") {
  Hooks hooks;
  hooks.keeps_state = true;
  hooks.place_needs_motion = GENERATE(false, true);
  const int threads = GENERATE(1, 4);
  ToySystem whole(hooks);
  whole.diary.checkpoint_each_frame = true;
  REQUIRE_FALSE(whole.drive(kLossless, threads).failure);
  const auto& entries = whole.diary.entries;
  REQUIRE(entries.size() == 30);
  REQUIRE(whole.diary.checkpoints.size() == 30);
  for (const engine::Checkpoint& checkpoint : whole.diary.checkpoints) {
    CHECK(checkpoint.counters.frames == checkpoint.frame + 1);
    if (checkpoint.frame == 29) continue;
    const std::vector<Diary::Entry> rest(entries.begin() + checkpoint.frame + 1, entries.end());
    CAPTURE(checkpoint.frame);
    CHECK(resumed(hooks, checkpoint, threads) == rest);
  }
}

TEST_CASE("an interrupt saves the state before the stages finish") {
  Hooks hooks;
  hooks.keeps_state = true;
  ToySystem system(hooks);
  int finished = -1;  // stages, at the time of the checkpoint
  hooks.map = [&](std::int64_t frame) {
    if (frame == 12) system.flag.set = true;
    finished = hooks.finished;
    return Status::ok();
  };
  CHECK(system.drive(kLossless, 2).interrupted);
  REQUIRE(system.diary.checkpoints.size() == 1);
  CHECK(system.diary.checkpoints[0].frame == system.diary.entries.back().frame);
  CHECK(finished == 0);
  CHECK(system.diary.checkpoints[0].states.size() == 3);
}

TEST_CASE("there are no checkpoints where a stage keeps no state, or after it could not save it") {
  Hooks hooks;
  hooks.keeps_state = GENERATE(false, true);
  hooks.cells_cannot_save = true;
  ToySystem system(hooks);
  system.diary.checkpoint_each_frame = true;
  const auto result = system.drive(kLossless, 2);
  CHECK_FALSE(result.failure);  // the run goes on
  CHECK(system.diary.entries.size() == 30);
  CHECK(system.diary.checkpoints.empty());
  const auto told = std::ranges::count_if(system.diary.events, [](const engine::Event& event) {
    return event.source == "cells" && event.message.find("no pen") != std::string::npos;
  });
  CHECK(told == (hooks.keeps_state ? 1 : 0));
}
