// SPDX-License-Identifier: BSD-3-Clause
// One-shot links and habituation, by hand.
#include "view_memory.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman::pose_cells;

namespace {

ViewMemory withViews(int count, const ViewSettings& settings = {}) {
  ViewMemory memory(settings);
  for (int id = 0; id < count; ++id) {
    REQUIRE_FALSE(memory.see(id, {static_cast<double>(id), 0, 0}));
  }
  return memory;
}

}  // namespace

TEST_CASE("a known view injects at the place where it was first seen") {
  ViewMemory memory = withViews(30);
  const auto injection = memory.see(4, {20, 20, 20});
  REQUIRE(injection);
  CHECK(injection->place.x == 4);
  CHECK(injection->energy == Approx(0.15 * (30 - std::exp(1.2)) / 30));
  CHECK(memory.see(4, {9, 9, 9})->place.x == 4);  // never averaged, never moved
}

TEST_CASE("the newest ten do not inject, also while there are fewer than ten (defect 5)") {
  // There the unsigned "size - 10" is huge, and every view passes for old.
  for (const int count : {1, 3, 9, 10}) {
    ViewMemory memory = withViews(count);
    for (int id = 0; id < count; ++id) CHECK_FALSE(memory.see(id, {}));
  }
  ViewMemory memory = withViews(12);
  CHECK(memory.see(1, {}));
  CHECK_FALSE(memory.see(2, {}));
}

TEST_CASE("a view seen on and on falls silent, and recovers when others are seen") {
  // Decay 1, 2, 3 ... less 0.04 a view: 30 - exp(1.2 d) is negative from d = 2.834.
  ViewMemory memory = withViews(40);
  CHECK(memory.see(0, {})->energy == Approx(0.15 * (30 - std::exp(1.2)) / 30));
  CHECK(memory.see(0, {})->energy == Approx(0.15 * (30 - std::exp(1.2 * 2)) / 30));
  CHECK_FALSE(memory.see(0, {}));
  CHECK_FALSE(memory.see(0, {}));
  for (int i = 0; i < 60; ++i) memory.see(1 + i % 20, {});
  CHECK(memory.see(0, {}));
}
