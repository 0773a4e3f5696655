// SPDX-License-Identifier: BSD-3-Clause
#include "app/exit_guard.hpp"

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <string_view>

#include "app/exit_code.hpp"

namespace tolman::app {
namespace {

/// Handlers of exit() take no argument and cannot be removed, so what they look at is static.
std::atomic<bool>& runIsOpen() {
  static std::atomic<bool> open = false;
  return open;
}

void onExit() {
  if (!runIsOpen()) return;
  constexpr std::string_view kText =
      "tolman: a plugin has called exit() in the host process, so the run is not complete; "
      "`isolation: process` of the stage protects the run, and `tolman run --resume` goes on from "
      "the last saved state\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kText.data(), kText.size());
  ::_exit(static_cast<int>(ExitCode::PluginFailed));
}

}  // namespace

ExitGuard::ExitGuard() {
  static const bool registered = std::atexit(onExit) == 0 && std::at_quick_exit(onExit) == 0;
  runIsOpen() = registered;
}

ExitGuard::~ExitGuard() { runIsOpen() = false; }

}  // namespace tolman::app
