// SPDX-License-Identifier: BSD-3-Clause
// Between two threads: the newest frame wins, rows are complete, and nobody waits without need.
#include "handover.hpp"

#include <catch2/catch.hpp>
#include <thread>

#include "drive.hpp"

namespace tolman::web_viewer {

using test::Moment;

TEST_CASE("the newest frame replaces the one that waits; rows and events add up") {
  Handover handover(false);
  for (std::int64_t i = 0; i < 25; ++i) (void)handover.put(Moment(i).snapshot());
  Delivery delivery;
  handover.take(delivery, true, true);
  REQUIRE(delivery.has_frame);
  CHECK(delivery.newest.frame == 24);
  CHECK(delivery.newest.motion.points.cols() == 2);
  CHECK(delivery.newest.cells.size() == 2);
  CHECK(delivery.rows.size() == 25);
  CHECK(delivery.rows[7][0] == 7);
  CHECK(delivery.events.size() == 3);
  REQUIRE(delivery.has_graph);
  CHECK(delivery.graph.frame == 20);
  CHECK(delivery.graph.experience_frame == std::vector<std::int32_t>{0, 10, 20});
  REQUIRE(delivery.views.size() == 3);
  CHECK(delivery.views[2].template_id == 2);
  handover.take(delivery, true, true);
  CHECK_FALSE(delivery.has_frame);
  CHECK_FALSE(delivery.has_graph);
  CHECK(delivery.rows.empty());
}

TEST_CASE("what is not wanted yet waits for the next time") {
  Handover handover(false);
  (void)handover.put(Moment(0).snapshot());
  Delivery delivery;
  handover.take(delivery, false, false);
  CHECK_FALSE(delivery.has_frame);
  CHECK(delivery.rows.size() == 1);
  handover.take(delivery, true, true);
  CHECK(delivery.has_frame);
  CHECK(delivery.has_graph);
  CHECK(delivery.rows.empty());
}

TEST_CASE("memory is bounded when nobody takes: events and views") {
  Handover handover(false);
  Moment moment(0);
  for (std::int64_t i = 0; i < 5000; ++i) {
    moment.frame.frame = moment.events[0].frame = 10 * i;
    (void)handover.put(moment.snapshot());
  }
  Delivery delivery;
  handover.take(delivery, true, true);
  CHECK(delivery.rows.size() == 5000);
  CHECK(delivery.events.size() == 100);
  CHECK(delivery.events.back().frame == 49990);
  CHECK(delivery.views.size() == 16);
}

TEST_CASE("with every frame asked for, the run waits until each was taken") {
  Handover handover(true);
  std::vector<std::int64_t> seen;
  std::thread run([&] {
    for (std::int64_t i = 0; i < 200; ++i) CHECK(handover.put(Moment(i, false).snapshot()));
  });
  Delivery delivery;
  while (seen.size() < 200) {
    handover.take(delivery, true, true);
    if (delivery.has_frame) seen.push_back(delivery.newest.frame);
  }
  run.join();
  for (std::size_t i = 0; i < seen.size(); ++i) REQUIRE(seen[i] == static_cast<std::int64_t>(i));
}

TEST_CASE("a closed handover lets a waiting run go") {
  Handover handover(true);
  (void)handover.put(Moment(0).snapshot());
  std::thread run([&] { CHECK_FALSE(handover.put(Moment(1).snapshot())); });
  handover.close();
  run.join();
}

}  // namespace tolman::web_viewer
