// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "app/program.hpp"
#include "engine/run.hpp"

using namespace tolman;
using app::exitCode;
using engine::FailureKind;

TEST_CASE("every kind of failure has its exit code, as docs/errors.md lists them") {
  const auto code = [](FailureKind kind) { return static_cast<int>(exitCode(kind)); };
  CHECK(code(FailureKind::Configuration) == 3);
  CHECK(code(FailureKind::Plugin) == 4);
  CHECK(code(FailureKind::Dataset) == 5);
  CHECK(code(FailureKind::Stage) == 7);
  CHECK(code(FailureKind::Record) == 8);
  CHECK(code(FailureKind::Continuation) == 9);
  CHECK(code(FailureKind::Machine) == 70);
}

TEST_CASE("of an outcome a failure counts first, then an interruption, then lost tracking") {
  engine::Outcome outcome;
  CHECK(exitCode(outcome) == app::ExitCode::Ok);
  outcome.counters.lost_at_end = true;
  CHECK(exitCode(outcome) == app::ExitCode::TrackingLost);
  outcome.counters.lost_at_end = false;
  outcome.counters.frames = outcome.counters.initialising = 2;
  CHECK(exitCode(outcome) == app::ExitCode::TrackingLost);
  outcome.counters.frames = 3;  // one of them was tracked
  CHECK(exitCode(outcome) == app::ExitCode::Ok);
  outcome.counters.frames = outcome.counters.initialising = 1;  // one frame shows no motion
  CHECK(exitCode(outcome) == app::ExitCode::TrackingLost);
  outcome.counters.lost_at_end = true;
  outcome.interrupted = true;
  CHECK(exitCode(outcome) == app::ExitCode::Interrupted);
  outcome.failure = engine::Failure{FailureKind::Stage, "broken"};
  CHECK(exitCode(outcome) == app::ExitCode::PluginFailed);
}
