// SPDX-License-Identifier: BSD-3-Clause
// What a library may change in the thread or process of the host by being opened or called, and the
// host or other plugins would notice: restored at the end of the scope.
#pragma once

#include <array>
#include <cfenv>
#include <csignal>
#include <locale>
#include <set>
#include <string>

namespace tolman::host {

class KeptState {
 public:
  KeptState();
  ~KeptState();
  KeptState(const KeptState&) = delete;
  KeptState& operator=(const KeptState&) = delete;

 private:
  /// Those that end a run, or that the host ignores or waits for.
  static constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ, SIGCHLD};

  unsigned mxcsr_;
  /// Rounding, traps, and subnormal numbers (-ffast-math flushes them to 0).
  std::fenv_t floats_{};
  std::string c_locale_;
  std::locale locale_;
  std::array<struct sigaction, kSignals.size()> handlers_{};
};

/// What was restored since the last call, by name.
std::set<std::string> takeRestored();

}  // namespace tolman::host
