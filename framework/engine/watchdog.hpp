// SPDX-License-Identifier: BSD-3-Clause
// Monitors a run: stages that do not answer, and a disk that runs full.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include "engine/chain.hpp"
#include "tolman/context.hpp"

namespace tolman::engine {

/// Bytes that an unprivileged user may still write below `directory`; -1 if not known.
std::int64_t diskLeft(const std::filesystem::path& directory);

/// Bytes that the run in `directory` needs for its end: the log of the record is merged into
/// run.sqlite, a state is saved, and results, figures and report are written.
std::int64_t diskNeeded(const std::filesystem::path& directory);

struct WatchdogSettings {
  double deadline_s = 0;  ///< of one call of a stage; 0: none
  std::function<std::int64_t()> disk_left;
  std::function<std::int64_t()> disk_needed;
  // Called from the watchdog's thread.
  std::function<void(LogLevel, std::string_view source, const std::string& text)> report;
  std::function<void(const std::string& why)> stop;  ///< called at most once
};

/// Reports a stage once when a call takes longer than the deadline, and again when it has answered.
/// Asks the run to stop when the disk has no more than the run needs for its end. Returns freed
/// memory to the system: long-lived data of map and record are between freed image buffers, whose
/// pages glibc keeps, and without this the process grows twice as fast as its data.
class Watchdog {
 public:
  Watchdog(const StageActivity& activity, const Clock& clock, WatchdogSettings settings)
      : activity_(activity), clock_(clock), settings_(std::move(settings)) {}

  /// Makes one check. start() makes one each second.
  void look();
  void start();

 private:
  void lookAt(Role role);
  void lookAtDisk();

  const StageActivity& activity_;
  const Clock& clock_;
  WatchdogSettings settings_;
  std::array<std::int64_t, kRoleNames.size()> reported_{};  ///< StageActivity of the call
  int looks_ = 0;
  bool stopped_ = false;
  std::jthread thread_;  // last, because it uses the members above
};

}  // namespace tolman::engine
