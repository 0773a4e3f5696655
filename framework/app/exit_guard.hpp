// SPDX-License-Identifier: BSD-3-Clause
// A plugin in the host process that calls exit() ends the program while its run is open. Without
// this the program would end with the plugin's exit code, for example 0.
#pragma once

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

}  // namespace tolman::app
