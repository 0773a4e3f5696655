// SPDX-License-Identifier: BSD-3-Clause
// The watchdog, with a clock and a disk of the test.
#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include "engine/run_listener.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::engine;

namespace {

struct SetClock : Clock {
  std::int64_t steadyNs() const override { return now_ns; }
  void advance(double s) { now_ns += static_cast<std::int64_t>(1e9 * s); }
  std::int64_t now_ns =
      std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
};

/// A watchdog, what it looks at, and what it reported.
struct Watched {
  explicit Watched(double deadline_s = 10) {
    settings.deadline_s = deadline_s;
    settings.disk_left = [this] { return disk; };
    settings.disk_needed = [] { return std::int64_t{100} << 20; };
    settings.report = [this](LogLevel level, std::string_view source, const std::string& text) {
      reported.push_back(std::string(enumName(level)) + " " + std::string(source) + ": " + text);
    };
    settings.stop = [this](const std::string& why) { stops.push_back(why); };
  }
  SetClock clock;
  StageActivity activity{};
  StageTimes times{};
  std::int64_t disk = -1;
  std::vector<std::string> reported;
  std::vector<std::string> stops;
  WatchdogSettings settings;
};

}  // namespace

TEST_CASE("a stage that does not answer in time is reported once, and its answer too") {
  Watched run;
  Watchdog watchdog(run.activity, run.clock, run.settings);
  {
    const StageTimer timer(run.activity, run.times, Role::Odometry);
    run.clock.advance(9);
    watchdog.look();
    CHECK(run.reported.empty());
    for (int i = 0; i < 3; ++i) {
      run.clock.advance(2);
      watchdog.look();
    }
    REQUIRE(run.reported.size() == 1);
    CHECK(run.reported[0].starts_with("warning odometry: has worked on one call for 11.0 s"));
  }
  watchdog.look();
  REQUIRE(run.reported.size() == 2);
  CHECK(run.reported[1].starts_with("info odometry: answered after at most 15.0 s"));
  watchdog.look();
  CHECK(run.reported.size() == 2);
}

TEST_CASE("each stage has its own time, a source that stalls included; observers have none") {
  const double deadline_s = GENERATE(0.5, 0.0);
  Watched run(deadline_s);
  Watchdog watchdog(run.activity, run.clock, run.settings);
  const StageTimer source(run.activity, run.times, Role::Source);
  const StageTimer map(run.activity, run.times, Role::Map);
  const StageTimer observer(run.activity, run.times, Role::Observer);
  run.clock.advance(1);
  watchdog.look();
  if (deadline_s == 0) {
    CHECK(run.reported.empty());
    return;
  }
  REQUIRE(run.reported.size() == 2);
  CHECK(run.reported[0].starts_with("warning source: "));
  CHECK(run.reported[1].starts_with("warning map: "));
}

TEST_CASE("a disk that is nearly full stops the run once, while it can still end well") {
  Watched run;
  Watchdog watchdog(run.activity, run.clock, run.settings);
  for (const std::int64_t mebibytes : {-1, 101}) {  // -1: not known
    run.disk = mebibytes < 0 ? -1 : mebibytes << 20;
    watchdog.look();
    CHECK(run.stops.empty());
  }
  run.disk = std::int64_t{90} << 20;
  watchdog.look();
  watchdog.look();
  REQUIRE(run.stops.size() == 1);
  CHECK(run.stops[0].find("90.0 MiB are left") != std::string::npos);
  CHECK(run.stops[0].find("--resume") != std::string::npos);
}

TEST_CASE("what a run needs to end grows with its record and its state") {
  const test::TemporaryFolder folder;
  const std::int64_t empty = diskNeeded(folder.path());
  CHECK(empty >= 1 << 20);
  std::ofstream(folder.path() / "run.sqlite-wal") << std::string(100'000, 'x');
  CHECK(diskNeeded(folder.path()) == empty + 100'000);
  std::filesystem::create_directory(folder.path() / "state");
  std::ofstream(folder.path() / "state/map.bin") << std::string(10'000, 'x');
  CHECK(diskNeeded(folder.path()) == empty + 120'000);
  CHECK(diskLeft(folder.path()) > 0);
  CHECK(diskLeft(folder.path() / "missing") == -1);
  CHECK(diskLeft("/proc") == -1);  // has no size
}
