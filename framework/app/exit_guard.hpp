// SPDX-License-Identifier: BSD-3-Clause
// A plugin in the host process that calls exit() ends the program while its run is open. Without
// this the program would end with the plugin's exit code, for example 0.
#pragma once

#include "app/exit_code.hpp"

namespace tolman::app {

/// While one exists, exit(), quick_exit(), _exit() and _Exit() end the process that made it with
/// ExitCode::PluginFailed and a message; its forked children are not affected. A system call
/// (exit_group) cannot be caught. At most one at a time.
class ExitGuard {
 public:
  ExitGuard();
  ~ExitGuard();
  ExitGuard(const ExitGuard&) = delete;
  ExitGuard& operator=(const ExitGuard&) = delete;
};

/// Ends the process as the program itself does, whether an ExitGuard exists or not. Callable from
/// handlers of signals.
[[noreturn]] void endAtOnce(ExitCode code);

}  // namespace tolman::app
