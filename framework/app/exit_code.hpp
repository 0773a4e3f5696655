// SPDX-License-Identifier: BSD-3-Clause
// How the program ends; docs/errors.md lists the same for users.
#pragma once

#include <string>

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
  Interrupted = 130,
};

/// Why a command ends early.
struct Failure {
  ExitCode code = ExitCode::Ok;
  std::string message;
};

}  // namespace tolman::app
