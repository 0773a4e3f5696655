// SPDX-License-Identifier: BSD-3-Clause
#include "engine/watchdog.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace tolman::engine {
namespace {

/// Observers are not watched, because one that serves a page works until the user ends the run.
constexpr std::array kWatched = {Role::Source, Role::Odometry, Role::Place, Role::Cells, Role::Map};

std::int64_t sizeOf(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  return error ? 0 : static_cast<std::int64_t>(size);
}

}  // namespace

std::int64_t diskLeft(const std::filesystem::path& directory) {
  std::error_code error;
  const auto space = std::filesystem::space(directory, error);
  return error || space.capacity == 0 ? -1 : static_cast<std::int64_t>(space.available);
}

std::int64_t diskNeeded(const std::filesystem::path& directory) {
  constexpr std::int64_t kResults = 8 << 20;  // report and figures, of any run
  std::int64_t state = 0;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(directory / "state", ignored)) {
    state += sizeOf(entry.path());
  }
  const std::int64_t trajectories = sizeOf(directory / "run.sqlite") / 8;
  return kResults + sizeOf(directory / "run.sqlite-wal") + 2 * state + trajectories;
}

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
  constexpr int kTrimEvery = 10;
  if (settings_.deadline_s > 0) {
    for (const Role role : kWatched) lookAt(role);
  }
  lookAtDisk();
#ifdef __GLIBC__
  if (++looks_ % kTrimEvery == 0) ::malloc_trim(0);
#endif
}

void Watchdog::lookAt(Role role) {
  std::int64_t& reported = reported_[static_cast<std::size_t>(role)];
  const std::int64_t since = activity_[static_cast<std::size_t>(role)];
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

void Watchdog::lookAtDisk() {
  const std::int64_t left = settings_.disk_left();
  const std::int64_t needed = settings_.disk_needed();
  if (stopped_ || left < 0 || left >= needed) return;
  stopped_ = true;
  const auto mebibytes = [](std::int64_t bytes) { return static_cast<double>(bytes) / (1 << 20); };
  settings_.stop(
      fmt::format("the disk is nearly full: {:.1f} MiB are left, and the run needs about {:.1f} "
                  "MiB to end well, so it stopped; free some space and go on with `tolman run "
                  "--resume`, or run it again if it has no checkpoint yet",
                  mebibytes(left), mebibytes(needed)));
}

}  // namespace tolman::engine
