// SPDX-License-Identifier: BSD-3-Clause
#include "app/exit_guard.hpp"

#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <string_view>

#include "app/exit_code.hpp"

namespace tolman::app {
namespace {

/// The process whose run is open; 0 for none. Handlers of exit() take no argument and cannot be
/// removed, and _exit() takes only the code, so what they look at is static.
std::atomic<::pid_t>& processOfRun() {
  static constinit std::atomic<::pid_t> process = 0;
  return process;
}

[[noreturn]] void endProcess(int code) {
  for (;;) ::syscall(SYS_exit_group, code);
}

/// Ends the process if its run is open. A child that a plugin has forked may end as it likes.
void onExit() {
  if (processOfRun() != ::getpid()) return;
  constexpr std::string_view kText =
      "tolman: a plugin has called exit() in the host process, so the run is not complete; "
      "`isolation: process` of the stage protects the run, and `tolman run --resume` goes on from "
      "the last saved state\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kText.data(), kText.size());
  endProcess(static_cast<int>(ExitCode::PluginFailed));
}

}  // namespace

void endAtOnce(ExitCode code) { endProcess(static_cast<int>(code)); }

ExitGuard::ExitGuard() {
  static const bool registered = std::atexit(onExit) == 0 && std::at_quick_exit(onExit) == 0;
  if (registered) processOfRun() = ::getpid();
}

ExitGuard::~ExitGuard() { processOfRun() = 0; }

}  // namespace tolman::app

// In place of those of the C library, for the program and for the libraries that it opens: the
// linker exports functions of a program that one of its libraries also defines.
extern "C" {

__attribute__((noreturn)) void _exit(int code) {  // NOLINT: the name is that of POSIX
  tolman::app::onExit();
  tolman::app::endProcess(code);
}

__attribute__((noreturn)) void _Exit(int code) noexcept {  // NOLINT: the name is that of C
  tolman::app::onExit();
  tolman::app::endProcess(code);
}
}
