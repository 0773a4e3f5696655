// SPDX-License-Identifier: BSD-3-Clause
// Monitors a run: stages that do not answer, memory and disk that run out.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "engine/resources.hpp"
#include "engine/stage_activity.hpp"
#include "tolman/context.hpp"

namespace tolman::run {

struct WatchdogSettings {
  double deadline_s = 0;  ///< of one call of a stage; 0: none
  // Remaining memory and disk, read at each check.
  std::function<std::optional<Memory>()> memory;
  std::function<std::optional<std::int64_t>()> disk;
  std::function<std::int64_t()> disk_needed;
  std::function<std::int64_t()> resident;  ///< bytes of this process in memory
  // Actions; called from the watchdog's thread.
  std::function<void()> return_memory;  ///< returns freed memory to the system
  std::function<void(LogLevel, std::string_view source, const std::string& text)> report;
  std::function<void(const std::string& why)> stop;  ///< called at most once

  /// Settings for the memory of this machine and the disk of `directory`, without a deadline. They
  /// return freed memory, but `report` and `stop` do nothing.
  static WatchdogSettings of(const std::filesystem::path& directory);
};

/// Reports a stage once when a call takes longer than the deadline, and again when it has answered.
/// Returns freed memory every 30 s, and when the process has grown since by 16 MiB or an eighth:
/// each correction of the map needs memory in proportion to the map, in the heap of the thread that
/// does it. Reports memory when less than a twentieth is left. Asks the run to stop when the disk
/// has no more than the run needs for its end.
class Watchdog {
 public:
  Watchdog(const pipeline::StageActivity& activity, const Clock& clock, WatchdogSettings settings);

  /// Makes one check. start() makes one each second.
  void look();
  void start();

 private:
  void lookAt(Role role);
  void returnMemory();
  void lookAtMemory();
  void lookAtDisk();

  const pipeline::StageActivity& activity_;
  const Clock& clock_;
  WatchdogSettings settings_;
  std::array<std::int64_t, kRoleNames.size()> reported_{};  ///< StageActivity::since() of the call
  std::int64_t returned_ns_;                                ///< when memory was last returned
  std::int64_t resident_ = 0;                               ///< bytes in memory directly after that
  bool memory_is_short_ = false;
  bool stopped_ = false;
  std::jthread thread_;  // last, because it uses the members above
};

}  // namespace tolman::run
