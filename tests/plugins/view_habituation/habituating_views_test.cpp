// SPDX-License-Identifier: BSD-3-Clause
// One-shot links and habituation, compared with values by hand.
#include "habituating_views.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman;

namespace {

/// A place may be of any type.
struct Place {
  double x = 0;
  double theta = 0;
};

using Views = HabituatingViews<Place>;

constexpr HabituationSettings kRatSlam = {0.15, 1, 0.04, 10};

Views withViews(int count) {
  Views memory(kRatSlam);
  for (int id = 0; id < count; ++id) {
    REQUIRE_FALSE(memory.see(id, {static_cast<double>(id), 0}));
  }
  return memory;
}

}  // namespace

TEST_CASE("a known view injects at the place where it was first seen") {
  Views memory = withViews(30);
  const auto injection = memory.see(4, {20, 20});
  REQUIRE(injection);
  CHECK(injection->place.x == 4);
  CHECK(injection->energy == Approx(0.15 * (30 - std::exp(1.2)) / 30));
  CHECK(memory.see(4, {9, 9})->place.x == 4);  // never averaged, never moved
}

TEST_CASE("the newest ten do not inject, also while there are fewer than ten (defect 5)") {
  // There the unsigned "size - 10" is huge, and every view passes for old.
  for (const int count : {1, 3, 9, 10}) {
    Views memory = withViews(count);
    for (int id = 0; id < count; ++id) CHECK_FALSE(memory.see(id, {}));
  }
  Views memory = withViews(12);
  CHECK(memory.see(1, {}));
  CHECK_FALSE(memory.see(2, {}));
}

TEST_CASE("a view seen on and on falls silent, and recovers when others are seen") {
  // Decay 1, 2, 3 ... less 0.04 a view: 30 - exp(1.2 d) is negative from d = 2.834.
  Views memory = withViews(40);
  CHECK(memory.see(0, {})->energy == Approx(0.15 * (30 - std::exp(1.2)) / 30));
  CHECK(memory.see(0, {})->energy == Approx(0.15 * (30 - std::exp(1.2 * 2)) / 30));
  CHECK_FALSE(memory.see(0, {}));
  CHECK_FALSE(memory.see(0, {}));
  for (int i = 0; i < 60; ++i) memory.see(1 + i % 20, {});
  CHECK(memory.see(0, {}));
}

TEST_CASE("with NeuroSLAM's constants a repeated view is silent at once, and rests in six views") {
  Views views({1, 2, 0.5, 0});
  CHECK_FALSE(views.see(4, {10, 5}));
  CHECK_FALSE(views.see(4, {}));  // exp(1.2 * 4) > 30
  views.see(9, {});
  CHECK_FALSE(views.see(4, {}));  // 4 less twice 0.5 is 3
  for (int k = 0; k < 4; ++k) views.see(10 + k, {});
  const auto injection = views.see(4, {});
  REQUIRE(injection);
  CHECK(injection->place.theta == 5);
  CHECK(injection->energy == Approx((30 - std::exp(2.4)) / 30));
}

TEST_CASE("nothing is injected among the first fifty views, and no view is too new after a gap") {
  Views views({.newest_ignored = 10, .first_ignored = 50});
  for (int id = 0; id < 30; ++id) views.see(id, {static_cast<double>(id), 0});
  for (int seen = 31; seen <= 50; ++seen) CHECK_FALSE(views.see(seen % 2, {}));
  CHECK(views.see(1, {}));  // the 51st
  CHECK_FALSE(views.see(25, {}));
  views.startPart();
  CHECK(views.see(26, {}));
  CHECK(views.find(7)->x == 7);
  CHECK(views.find(99) == nullptr);
}
