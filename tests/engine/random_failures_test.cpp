// SPDX-License-Identifier: BSD-3-Clause
// Stages that fail at random frames: published records, counts and messages depend only on the
// random numbers, for any number of threads.
#include <algorithm>
#include <map>
#include <set>

#include "engine/toy_stages.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using config::FailurePolicy;
using tolman::test::Diary;
using tolman::test::Hooks;
using tolman::test::ToySystem;

namespace {

constexpr std::int64_t kFrames = 60;

/// The frames at which each stage fails.
struct Draws {
  std::array<std::set<std::int64_t>, 4> failing;  ///< odometry, place, cells, map

  Draws(RandomStream& random, double share) {
    for (auto& frames : failing) {
      for (std::int64_t frame = 1; frame < kFrames; ++frame) {
        if (random.uniform() < share) frames.insert(frame);
      }
    }
  }
  /// The frames at which at least one stage fails.
  std::int64_t count() const {
    std::set<std::int64_t> any;
    for (const auto& frames : failing) any.insert(frames.begin(), frames.end());
    return static_cast<std::int64_t>(any.size());
  }
  void set(Hooks& hooks) const {
    hooks.frames = kFrames;
    const std::array stages = {&Hooks::odometry, &Hooks::place, &Hooks::cells, &Hooks::map};
    for (std::size_t i = 0; i < stages.size(); ++i) {
      hooks.*stages[i] = [frames = failing[i]](std::int64_t frame) {
        return frames.contains(frame) ? Status::failed("broken") : Status::ok();
      };
    }
  }
};

constexpr engine::Policies kSkipAll = {FailurePolicy::Skip, FailurePolicy::Skip,
                                       FailurePolicy::Skip, FailurePolicy::Skip,
                                       FailurePolicy::Skip, FailurePolicy::Skip};

}  // namespace

TEST_CASE("skipped failures leave every frame published, counted, and the same for any threads") {
  RandomStream random(71);
  for (int round = 0; round < 12; ++round) {
    const Draws draws(random, 0.02 * round);
    std::vector<Diary::Entry> first;
    for (const int threads : {1, 2, 4}) {
      Hooks hooks;
      draws.set(hooks);
      ToySystem system(hooks);
      const auto result = system.drive({}, threads, kSkipAll);
      CAPTURE(round, threads);
      REQUIRE_FALSE(result.failure);
      REQUIRE(result.counters.frames == kFrames);
      REQUIRE(result.counters.skipped == draws.count());
      REQUIRE(system.diary.entries.size() == static_cast<std::size_t>(kFrames));
      for (std::int64_t frame = 0; frame < kFrames; ++frame) {
        const Diary::Entry& entry = system.diary.entries[static_cast<std::size_t>(frame)];
        REQUIRE(entry.frame == frame);
        REQUIRE(entry.lost == draws.failing[0].contains(frame));
        REQUIRE((entry.template_id == -1) == draws.failing[1].contains(frame));
      }
      if (first.empty()) first = system.diary.entries;
      REQUIRE(system.diary.entries == first);
    }
  }
}

TEST_CASE("where some stages stop the run, it ends before the first frame that one of them fails") {
  RandomStream random(73);
  for (int round = 0; round < 20; ++round) {
    const Draws draws(random, 0.05);
    engine::Policies policies = kSkipAll;
    std::int64_t end = kFrames;
    for (std::size_t i = 0; i < 4; ++i) {
      if (random.below(2) == 0) continue;
      policies.at(i + 1) = FailurePolicy::Stop;  // after that of the source
      if (!draws.failing[i].empty()) end = std::min(end, *draws.failing[i].begin());
    }
    for (const int threads : {1, 3}) {
      Hooks hooks;
      draws.set(hooks);
      ToySystem system(hooks);
      const auto result = system.drive({}, threads, policies);
      CAPTURE(round, threads, end);
      REQUIRE(result.failure.has_value() == (end < kFrames));
      REQUIRE(system.diary.entries.size() == static_cast<std::size_t>(end));
      REQUIRE(result.counters.frames == end);
      REQUIRE(hooks.finished == 4);
    }
  }
}
