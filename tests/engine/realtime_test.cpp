// SPDX-License-Identifier: BSD-3-Clause
// Drop policies, repeatable: odometry waits in frame 0 until the source has given all frames.
#include <chrono>
#include <thread>

#include "engine/toy_stages.hpp"

using namespace tolman;
using config::PipelineMode;
using config::QueuePolicy;
using tolman::test::Hooks;
using tolman::test::ToySystem;

namespace {

config::PipelineSettings realtime(QueuePolicy policy) {
  config::PipelineSettings settings;
  settings.mode = PipelineMode::Realtime;
  settings.queue = 2;
  settings.input_policy = policy;
  settings.speed = 1000;
  return settings;
}

/// Runs 20 frames into a jam; the frames that came through.
std::vector<std::int64_t> jam(QueuePolicy policy, engine::DriveResult& result) {
  Hooks hooks;
  hooks.frames = 20;
  std::atomic<std::int64_t> given = -1;
  hooks.source = [&](std::int64_t frame) {
    given = frame;
    return Status::ok();
  };
  hooks.odometry = [&](std::int64_t frame) {
    while (frame == 0 && given < 19) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    // The last frame was given; let the feeder put it into the queue as well.
    if (frame == 0) std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return Status::ok();
  };
  ToySystem system(hooks);
  result = system.drive(realtime(policy), 2);
  std::vector<std::int64_t> frames;
  for (const auto& entry : system.diary.entries) frames.push_back(entry.frame);
  CHECK_FALSE(result.failure);
  CHECK(result.counters.frames + result.counters.dropped == 20);
  // One event for each, and a last one about the effect on the files.
  const auto events = static_cast<std::int64_t>(system.diary.events.size());
  CHECK(events == result.counters.dropped + (result.counters.dropped > 0 ? 1 : 0));
  return frames;
}

}  // namespace

TEST_CASE("drop_oldest keeps the newest frames") {
  engine::DriveResult result;
  CHECK(jam(QueuePolicy::DropOldest, result) == std::vector<std::int64_t>{0, 1, 18, 19});
  CHECK(result.counters.dropped == 16);
}

TEST_CASE("block drops nothing") {
  Hooks hooks;
  hooks.frames = 40;
  hooks.odometry = [](std::int64_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return Status::ok();
  };
  ToySystem system(hooks);
  const auto result = system.drive(realtime(QueuePolicy::Block), 2);
  CHECK(result.counters.frames == 40);
  CHECK(result.counters.dropped == 0);
}

TEST_CASE("a realtime run measures what its stages take at least, a lossless one nothing") {
  Hooks hooks;
  hooks.frames = 5;
  hooks.odometry = [](std::int64_t) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return Status::ok();
  };
  config::PipelineSettings settings;
  settings.input_policy = QueuePolicy::Block;
  ToySystem lossless(hooks);
  CHECK(lossless.drive(settings, 2).latency.frames == 0);
  settings.mode = PipelineMode::Realtime;
  settings.speed = 1000;
  ToySystem realtime(hooks);
  const engine::Latency latency = realtime.drive(settings, 2).latency;
  CHECK(latency.frames == 5);
  CHECK(latency.median_ms >= 20);  // sleeping is never shorter
  CHECK(latency.p99_ms >= latency.median_ms);
}
