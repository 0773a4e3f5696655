// SPDX-License-Identifier: BSD-3-Clause
// How the program ends; docs/errors.md lists the same for users.
#pragma once

#include "engine/failure.hpp"

namespace tolman::run {
struct Outcome;
}

namespace tolman::app {

enum class ExitCode : int {
  Ok = 0,
  Usage = 2,
  Configuration = 3,
  Plugin = 4,
  Dataset = 5,
  TrackingLost = 6,
  PluginFailed = 7,
  Record = 8,
  Session = 9,
  Internal = 70,
  Interrupted = 130,
};

ExitCode exitCode(run::FailureKind kind);
ExitCode exitCode(const run::Outcome& outcome);

}  // namespace tolman::app
