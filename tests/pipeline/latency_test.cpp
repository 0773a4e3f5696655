// SPDX-License-Identifier: BSD-3-Clause
// Percentiles against their definition, the clock of the exposure, and what a realtime run
// measures.
#include "engine/latency.hpp"

#include <catch2/catch.hpp>
#include <thread>

#include "pipeline/toy_stages.hpp"

using namespace tolman;
using namespace tolman::pipeline;
using namespace std::chrono_literals;

TEST_CASE("median and 99 % are values that so many frames do not exceed") {
  LatencyMeter meter;
  CHECK(meter.result(ExposureClock::Pace).frames == 0);
  for (int i = 0; i < 200; ++i) meter.add(std::chrono::milliseconds(i * 77 % 200 + 1));  // 1 to 200
  const Latency latency = meter.result(ExposureClock::Monotonic);
  CHECK(latency.frames == 200);
  CHECK(latency.median_ms == Approx(100));
  CHECK(latency.p99_ms == Approx(198));
  CHECK(latency.clock == ExposureClock::Monotonic);
  LatencyMeter one;
  one.add(7ms);
  CHECK(one.result(ExposureClock::Pace).median_ms == Approx(7));
  CHECK(one.result(ExposureClock::Pace).p99_ms == Approx(7));
}

TEST_CASE("stamps count as exposures where they are recent ones of a source without an end") {
  constexpr std::int64_t kSecond = 1'000'000'000;
  constexpr std::int64_t kUp = 5000 * kSecond;
  constexpr std::int64_t kUtc = 1'790'000'000 * kSecond;
  CHECK(exposureClock(true, kUp - kSecond / 10, kUp, kUtc) == ExposureClock::Monotonic);
  CHECK(exposureClock(true, kUtc - kSecond / 10, kUp, kUtc) == ExposureClock::System);
  CHECK(exposureClock(false, kUtc - kSecond / 10, kUp, kUtc) == ExposureClock::Pace);
  CHECK(exposureClock(true, kUtc - 60 * kSecond, kUp, kUtc) == ExposureClock::Pace);
  CHECK(exposureClock(true, kUtc + kSecond, kUp, kUtc) == ExposureClock::Pace);
  CHECK(exposureClock(true, 0, kUp, kUtc) == ExposureClock::Pace);
}

TEST_CASE("a realtime run measures what its stages take at least, a lossless one nothing") {
  test::Hooks hooks;
  hooks.frames = 5;
  hooks.odometry = [](std::int64_t) {
    std::this_thread::sleep_for(20ms);
    return Status::ok();
  };
  config::PipelineSettings settings;
  settings.input_policy = config::QueuePolicy::Block;
  test::ToySystem lossless(hooks);
  CHECK(lossless.drive(settings, 2).latency.frames == 0);
  settings.mode = config::PipelineMode::Realtime;
  settings.speed = 1000;
  test::ToySystem realtime(hooks);
  const Latency latency = realtime.drive(settings, 2).latency;
  CHECK(latency.frames == 5);
  CHECK(latency.median_ms >= 20);  // sleeping is never shorter
  CHECK(latency.p99_ms >= latency.median_ms);
  CHECK(latency.clock == ExposureClock::Pace);
}
