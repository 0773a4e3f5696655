// SPDX-License-Identifier: BSD-3-Clause
#include "engine/watchdog.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace tolman::run {
namespace {

/// Observers are not watched, because one that serves a page works until the user ends the run.
constexpr std::array kWatched = {Role::Source, Role::Odometry, Role::Place, Role::Cells, Role::Map};

constexpr double kMemoryShare = 0.05;  // memory is short below this share of the limit

double mebibytes(std::int64_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

}  // namespace

WatchdogSettings WatchdogSettings::of(const std::filesystem::path& directory) {
  return {0,
          memoryLeft,
          [=] { return diskLeft(directory); },
          [=] { return diskNeeded(directory); },
          residentMemory,
          returnFreedMemory,
          [](LogLevel, std::string_view, const std::string&) {},
          [](const std::string&) {}};
}

Watchdog::Watchdog(const pipeline::StageActivity& activity, const Clock& clock,
                   WatchdogSettings settings)
    : activity_(activity),
      clock_(clock),
      settings_(std::move(settings)),
      returned_ns_(clock.steadyNs()) {}

void Watchdog::start() {
  thread_ = std::jthread([this](const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
      look();
      wake.wait_for(lock, stop, std::chrono::seconds(1), [] { return false; });
    }
  });
}

void Watchdog::look() {
  if (settings_.deadline_s > 0) {
    for (const Role role : kWatched) lookAt(role);
  }
  returnMemory();
  lookAtMemory();
  lookAtDisk();
}

void Watchdog::lookAt(Role role) {
  std::int64_t& reported = reported_[static_cast<std::size_t>(role)];
  const std::int64_t since = activity_.since(role);
  const auto seconds = [&](std::int64_t begin) {
    return 1e-9 * static_cast<double>(clock_.steadyNs() - begin);
  };
  if (reported != 0 && since != reported) {
    settings_.report(LogLevel::Info, enumName(role),
                     fmt::format("answered after at most {:.1f} s", seconds(reported)));
    reported = 0;
  }
  if (since == 0 || reported == since || seconds(since) < settings_.deadline_s) return;
  reported = since;
  settings_.report(LogLevel::Warning, enumName(role),
                   fmt::format("has worked on one call for {:.1f} s; the deadline is {:.3g} s "
                               "(pipeline.stage_deadline). The run waits for it",
                               seconds(since), settings_.deadline_s));
}

void Watchdog::returnMemory() {
  constexpr std::int64_t kEvery = 30'000'000'000;  // ns
  constexpr std::int64_t kGrowth = 16 << 20;       // bytes
  const bool has_grown = settings_.resident() > resident_ + std::max(kGrowth, resident_ / 8);
  if (!has_grown && clock_.steadyNs() - returned_ns_ < kEvery) return;
  returned_ns_ = clock_.steadyNs();
  settings_.return_memory();
  resident_ = settings_.resident();
}

void Watchdog::lookAtMemory() {
  const std::optional<Memory> memory = settings_.memory();
  if (!memory) return;
  const double share = static_cast<double>(memory->left) / static_cast<double>(memory->limit);
  const bool is_short = share < (memory_is_short_ ? 2 * kMemoryShare : kMemoryShare);
  if (is_short && !memory_is_short_) {
    settings_.report(LogLevel::Warning, "memory",
                     fmt::format("nearly used up: {:.0f} of {:.0f} MiB are left",
                                 mebibytes(memory->left), mebibytes(memory->limit)));
  }
  memory_is_short_ = is_short;
}

void Watchdog::lookAtDisk() {
  if (stopped_) return;
  const std::optional<std::int64_t> left = settings_.disk();
  if (!left) return;
  const std::int64_t needed = settings_.disk_needed();
  if (*left >= needed) return;
  stopped_ = true;
  settings_.stop(
      fmt::format("the disk is nearly full: {:.1f} MiB are left, and the run needs about {:.1f} "
                  "MiB to end well, so it stopped; free some space and go on with `tolman run "
                  "--resume`, or run it again if it has no checkpoint yet",
                  mebibytes(*left), mebibytes(needed)));
}

}  // namespace tolman::run
