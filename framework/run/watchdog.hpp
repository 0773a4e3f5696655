// SPDX-License-Identifier: BSD-3-Clause
// Looks after a run while it goes on: stages that do not answer, memory that runs short, a disk
// that fills up.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "pipeline/activity.hpp"
#include "run/resources.hpp"
#include "tolman/context.hpp"

namespace tolman::run {

struct WatchdogSettings {
  double deadline_s = 0;  ///< of one call of a stage; 0: none
  // What is left, asked at each look.
  std::function<std::optional<Memory>()> memory;
  std::function<std::optional<std::int64_t>()> disk;
  std::function<std::int64_t()> disk_needed;
  // What to do; called from the watchdog's thread.
  std::function<void()> return_memory;  ///< every 30 s: gives freed memory back to the system
  std::function<void(LogLevel, std::string_view source, const std::string& text)> report;
  std::function<void(const std::string& why)> stop;  ///< at most once

  /// Looks at this machine and at the disk of `directory`; has no deadline, and does nothing.
  static WatchdogSettings of(const std::filesystem::path& directory);
};

/// Reports a stage once when it has worked on one call for longer than the deadline, and again when
/// it has answered; memory when less than a twentieth is left. When the disk has no more than the
/// run needs to end well, it asks the run to stop.
class Watchdog {
 public:
  Watchdog(const pipeline::Activity& activity, const Clock& clock, WatchdogSettings settings);

  /// One look. start() makes one each second.
  void look();
  void start();

 private:
  void lookAt(Role role);
  void returnMemory();
  void lookAtMemory();
  void lookAtDisk();

  const pipeline::Activity& activity_;
  const Clock& clock_;
  WatchdogSettings settings_;
  std::array<std::int64_t, kRoleNames.size()> reported_{};  ///< Activity::since() of the call
  std::int64_t returned_ns_;                                ///< when memory was given back
  bool memory_is_short_ = false;
  bool stopped_ = false;
  std::jthread thread_;  // last, because it uses the members above
};

}  // namespace tolman::run
