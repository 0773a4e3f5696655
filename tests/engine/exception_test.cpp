// SPDX-License-Identifier: BSD-3-Clause
// Exceptions of the host itself within the flow, such as of memory that is short.
#include <new>
#include <stdexcept>

#include "engine/toy_stages.hpp"
#include "host/guard.hpp"

using namespace tolman;
using tolman::test::Hooks;
using tolman::test::ToySystem;

namespace {

config::PipelineSettings settingsOf(config::PipelineMode mode) {
  config::PipelineSettings settings;
  settings.mode = mode;
  settings.speed = 1000;
  return settings;
}

}  // namespace

TEST_CASE("an exception in the flow is a failure, and frames before it are kept") {
  const auto mode = GENERATE(config::PipelineMode::Lossless, config::PipelineMode::Realtime);
  const int threads = GENERATE(1, 4);
  Hooks hooks;
  hooks.frames = 40;
  ToySystem system(hooks);
  system.diary.on_frame = [](std::int64_t frame) -> Status {
    if (frame >= 7) throw std::bad_alloc();
    return Status::ok();
  };
  const auto result = system.drive(settingsOf(mode), threads);
  REQUIRE(result.failure);
  CHECK(result.failure->stage == enumName(Role::Observer));
  CHECK(result.failure->kind == engine::FailureKind::Machine);
  CHECK(system.diary.entries.size() >= 1);
  CHECK(hooks.finished == 4);  // all stages are finished as after any failure
}

TEST_CASE("a flow that fails again and again leaves no task behind") {
  for (int i = 0; i < 200; ++i) {
    Hooks hooks;
    hooks.frames = 20;
    ToySystem system(hooks);
    system.diary.on_frame = [&](std::int64_t frame) -> Status {
      if (frame >= i % 5) throw std::runtime_error("no");
      return Status::ok();
    };
    const auto result = system.drive(settingsOf(config::PipelineMode::Lossless), 4);
    REQUIRE(result.failure);
    CHECK(result.failure->message.find("no") != std::string::npos);
  }
}
