// SPDX-License-Identifier: BSD-3-Clause
// A stage that waits for its own parallel loop executes no tasks of other stages.
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_group.h>

#include <atomic>
#include <catch2/catch.hpp>

#include "engine/chain.hpp"

using namespace tolman;

namespace {

thread_local bool t_in_stage = false;

}  // namespace

TEST_CASE("a call without other tasks runs none of them while it waits") {
  std::atomic<int> intrusions = 0;
  std::atomic<int> others = 0;
  tbb::task_arena arena(2);
  arena.execute([&] {
    tbb::task_group other_stages;
    for (int round = 0; round < 200; ++round) {
      other_stages.run([&] {
        intrusions += t_in_stage ? 1 : 0;
        ++others;
      });
      t_in_stage = true;
      const int answer = engine::withoutOtherTasks([] {
        std::atomic<int> sum = 0;
        tbb::parallel_for(0, 100, [&](int i) { sum += i; });
        return sum.load();
      });
      t_in_stage = false;
      CHECK(answer == 4950);
    }
    other_stages.wait();
  });
  CHECK(others == 200);
  CHECK(intrusions == 0);
}
