// SPDX-License-Identifier: BSD-3-Clause
// kill -9 at any moment loses at most the last second.
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>

#include "record/by_hand.hpp"
#include "record/export.hpp"
#include "record/run_reader.hpp"
#include "record/sample_run.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;
using std::chrono::steady_clock;

namespace {

constexpr std::size_t kMaxFrames = 20'000;

/// Shared with the child: when each frame was handed to the recorder.
struct Diary {
  std::atomic<std::size_t> frames;
  std::array<steady_clock::time_point, kMaxFrames> recorded;
};

void recordUntilKilled(const std::filesystem::path& folder, Diary& diary, std::size_t frames) {
  auto recorder = Recorder::open(folder);
  if (!recorder.isOk()) _exit(2);
  for (std::size_t i = 0; i < frames; ++i) {
    if (!test::recordFrame(*recorder.value(), static_cast<std::int64_t>(i)).isOk()) _exit(3);
    diary.recorded[i] = steady_clock::now();
    diary.frames = i + 1;
    usleep(500);
  }
  for (;;) pause();  // frames stop coming, the program lives on
}

/// Kills a child that records at most `frames` frames, `delay_ms` after its first.
void killAndCheck(std::size_t frames, unsigned delay_ms) {
  const test::TemporaryFolder folder;
  void* memory =
      mmap(nullptr, sizeof(Diary), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  REQUIRE(memory != MAP_FAILED);
  Diary& diary = *new (memory) Diary{};
  const pid_t child = fork();
  if (child == 0) recordUntilKilled(folder.path(), diary, frames);
  while (diary.frames == 0) usleep(1000);
  usleep(delay_ms * 1000);
  kill(child, SIGKILL);
  const auto killed = steady_clock::now();
  waitpid(child, nullptr, 0);

  const auto reader = RunReader::open(folder.path());
  REQUIRE(reader.isOk());
  const auto rows = reader.value()->records<Frame>().value();
  std::size_t safe = 0;  // frames older than the last second
  while (safe < diary.frames && killed - diary.recorded[safe] > std::chrono::seconds(1)) ++safe;
  CHECK(rows.size() >= safe);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    REQUIRE(rows[i].frame == static_cast<std::int64_t>(i));
  }
  CHECK(reader.value()->odometry().value().size() == rows.size());
  if (!rows.empty()) {
    CHECK(exportRun(folder.path(), folder.path()).value().size() == kExportedFiles.size());
  }
  CHECK(test::queryByHand(folder.path(), "PRAGMA integrity_check; PRAGMA foreign_key_check") ==
        std::vector<std::string>{"ok"});
  munmap(memory, sizeof(Diary));
}

}  // namespace

TEST_CASE("killed while recording") {
  RandomStream random(41);
  for (int round = 0; round < 4; ++round) {
    killAndCheck(kMaxFrames, static_cast<unsigned>(random.below(1900)));
  }
}

TEST_CASE("killed long after the last frame: nothing is lost") { killAndCheck(50, 1300); }
