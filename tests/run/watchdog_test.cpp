// SPDX-License-Identifier: BSD-3-Clause
// The watchdog, with a clock and resources of the test.
#include "engine/watchdog.hpp"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include "support/data.hpp"

using namespace tolman;
using namespace tolman::run;

namespace {

struct SetClock : Clock {
  std::int64_t steadyNs() const override { return now_ns; }
  void advance(double s) { now_ns += static_cast<std::int64_t>(1e9 * s); }
  std::int64_t now_ns =
      std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
};

/// A watchdog, what it looks at, and what it said.
struct Watched {
  explicit Watched(double deadline_s = 10) {
    settings.deadline_s = deadline_s;
    settings.memory = [this] { return memory; };
    settings.disk = [this] { return disk; };
    settings.disk_needed = [] { return std::int64_t{100} << 20; };
    settings.resident = [this] { return resident; };
    settings.return_memory = [this] {
      ++returned;
      resident = std::min(resident, in_use);
    };
    settings.report = [this](LogLevel level, std::string_view source, const std::string& text) {
      said.push_back(std::string(enumName(level)) + " " + std::string(source) + ": " + text);
    };
    settings.stop = [this](const std::string& why) { stops.push_back(why); };
  }
  SetClock clock;
  pipeline::StageActivity activity;
  std::optional<Memory> memory;
  std::optional<std::int64_t> disk;
  std::int64_t resident = 0;
  std::int64_t in_use = 0;
  int returned = 0;
  std::vector<std::string> said;
  std::vector<std::string> stops;
  WatchdogSettings settings;
};

}  // namespace

TEST_CASE("freed memory is given back to the system every half minute") {
  Watched watched;
  Watchdog watchdog(watched.activity, watched.clock, watched.settings);
  for (int second = 1; second <= 95; ++second) {
    watched.clock.advance(1);
    watchdog.look();
    CHECK(watched.returned == second / 30);
  }
}

TEST_CASE("freed memory is given back when 16 MiB or an eighth of the memory has gathered") {
  Watched watched;
  Watchdog watchdog(watched.activity, watched.clock, watched.settings);
  const auto returnedAt = [&](std::int64_t mebibytes) {
    const int before = watched.returned;
    watched.clock.advance(1);
    watched.resident = mebibytes << 20U;
    watchdog.look();
    return watched.returned > before;
  };
  watched.in_use = std::int64_t{100} << 20U;
  CHECK(returnedAt(120));  // the first time
  CHECK_FALSE(returnedAt(116));
  CHECK(returnedAt(117));
  CHECK_FALSE(returnedAt(110));
  watched.in_use = std::int64_t{400} << 20U;
  CHECK(returnedAt(400));  // all in use: not again before an eighth more
  CHECK_FALSE(returnedAt(450));
  CHECK(returnedAt(451));
}

TEST_CASE("a stage that does not answer in time is reported once, and its answer too") {
  Watched run;
  Watchdog watchdog(run.activity, run.clock, run.settings);
  {
    const pipeline::StageActivity::Mark mark(run.activity, Role::Odometry);
    run.clock.advance(9);
    watchdog.look();
    CHECK(run.said.empty());
    for (int i = 0; i < 3; ++i) {
      run.clock.advance(2);
      watchdog.look();
    }
    REQUIRE(run.said.size() == 1);
    CHECK(run.said[0].starts_with("warning odometry: has worked on one call for 11.0 s"));
  }
  watchdog.look();
  REQUIRE(run.said.size() == 2);
  CHECK(run.said[1].starts_with("info odometry: answered after at most 15.0 s"));
  watchdog.look();
  CHECK(run.said.size() == 2);
}

TEST_CASE("each stage has its own time, a source that stalls included; observers have none") {
  Watched run(0.5);
  Watchdog watchdog(run.activity, run.clock, run.settings);
  const pipeline::StageActivity::Mark source(run.activity, Role::Source);
  const pipeline::StageActivity::Mark map(run.activity, Role::Map);
  const pipeline::StageActivity::Mark observer(run.activity, Role::Observer);
  run.clock.advance(1);
  watchdog.look();
  REQUIRE(run.said.size() == 2);
  CHECK(run.said[0].starts_with("warning source: "));
  CHECK(run.said[1].starts_with("warning map: "));
}

TEST_CASE("without a deadline nothing is late") {
  Watched run(0);
  Watchdog watchdog(run.activity, run.clock, run.settings);
  const pipeline::StageActivity::Mark mark(run.activity, Role::Place);
  run.clock.advance(1e6);
  watchdog.look();
  CHECK(run.said.empty());
}

TEST_CASE("memory that runs short is told when it begins, not while it stays so") {
  Watched run;
  Watchdog watchdog(run.activity, run.clock, run.settings);
  const auto look = [&](std::int64_t left) {
    run.memory = Memory{left << 20, std::int64_t{1000} << 20};
    watchdog.look();
    return run.said.size();
  };
  CHECK(look(500) == 0);
  CHECK(look(51) == 0);
  CHECK(look(49) == 1);
  CHECK(run.said[0] == "warning memory: nearly used up: 49 of 1000 MiB are left");
  CHECK(look(60) == 1);  // not yet recovered
  CHECK(look(49) == 1);
  CHECK(look(200) == 1);
  CHECK(look(10) == 2);
}

TEST_CASE("a disk that is nearly full stops the run once, while it can still end well") {
  Watched run;
  Watchdog watchdog(run.activity, run.clock, run.settings);
  run.disk = std::int64_t{101} << 20;
  watchdog.look();
  CHECK(run.stops.empty());
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
  CHECK(diskLeft(folder.path()).value() > 0);
  CHECK_FALSE(diskLeft(folder.path() / "missing"));
  CHECK_FALSE(diskLeft("/proc"));  // has no size
}

TEST_CASE("memory is that of the tightest limit") {
  const Memory free = memoryLeft().value();
  CHECK(free.left > 0);
  CHECK(free.left <= free.limit);
#if !defined(__SANITIZE_ADDRESS__)  // which reserves terabytes of addresses
  rlimit before{};
  REQUIRE(::getrlimit(RLIMIT_AS, &before) == 0);
  const rlimit narrow{rlim_t{3} << 30U, before.rlim_max};
  REQUIRE(::setrlimit(RLIMIT_AS, &narrow) == 0);
  const Memory limited = memoryLeft().value();
  ::setrlimit(RLIMIT_AS, &before);
  CHECK(limited.limit <= std::int64_t{3} << 30);
  CHECK(limited.left < limited.limit);
#endif
}
