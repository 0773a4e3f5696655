// SPDX-License-Identifier: BSD-3-Clause
// Data passed between two threads: newest frame, all rows, bounded memory, waiting.
#include "handover.hpp"

#include <catch2/catch.hpp>
#include <thread>

#include "watched_run.hpp"

namespace tolman::web_viewer {

using test::TestFrame;

namespace {

std::size_t rowCount(const PendingData& pending) {
  return pending.rows.size() / rowColumns().size();
}

}  // namespace

TEST_CASE("the newest frame replaces a waiting one; rows and events accumulate") {
  Handover handover(false);
  for (std::int64_t i = 0; i < 25; ++i) (void)handover.put(TestFrame(i).snapshot());
  PendingData pending;
  handover.take(pending, true, true);
  REQUIRE(pending.has_frame);
  CHECK(pending.newest.frame == 24);
  CHECK(pending.newest.points.cols() == 2);
  CHECK(pending.newest.cells.size() == 2);
  CHECK(rowCount(pending) == 25);
  CHECK(pending.rows[7 * rowColumns().size()] == 7);
  CHECK(pending.events.size() == 3);
  REQUIRE(pending.has_graph);
  CHECK(pending.graph.header.frame == 20);
  CHECK(pending.graph.experience.size() == 3 * 4);
  REQUIRE(pending.template_images.size() == 3);
  CHECK(pending.template_images[2].template_id == 2);
  handover.take(pending, true, true);
  CHECK_FALSE(pending.has_frame);
  CHECK_FALSE(pending.has_graph);
  CHECK(pending.rows.empty());
}

TEST_CASE("frame and graph wait until they are asked for") {
  Handover handover(false);
  (void)handover.put(TestFrame(0).snapshot());
  PendingData pending;
  handover.take(pending, false, false);
  CHECK_FALSE(pending.has_frame);
  CHECK(rowCount(pending) == 1);
  handover.take(pending, true, true);
  CHECK(pending.has_frame);
  CHECK(pending.has_graph);
  CHECK(pending.rows.empty());
}

TEST_CASE("the newest pose moves with the final graph, and stays at its place in it") {
  Handover handover(false);
  TestFrame last(24);
  last.map.experience = 2;
  last.map.T_experience_camera.translation() << 0, 0, 4;
  (void)handover.put(last.snapshot());
  MapGraph graph = test::graphAt(24);
  const Eigen::AngleAxisd turn(0.5, Eigen::Vector3d::UnitY());
  graph.experiences[2].T_world_experience.linear() = turn.toRotationMatrix();
  graph.experiences[2].T_world_experience.translation() << 1, 0, 19;
  handover.putGraph(graph);
  PendingData pending;
  handover.take(pending, true, true);
  CHECK(pending.pose.frame == 24);
  // By hand: 4 m ahead of an experience that looks 0.5 rad to the right.
  const Eigen::Vector3d p = pending.pose.T_world_camera.translation();
  CHECK(p.x() == Approx(1 + 4 * std::sin(0.5)));
  CHECK(p.z() == Approx(19 + 4 * std::cos(0.5)));
}

TEST_CASE("events and template images are bounded in number") {
  Handover handover(false);
  TestFrame test_frame(0);
  for (std::int64_t i = 0; i < 5000; ++i) {
    test_frame.frame.frame = test_frame.events[0].frame = 10 * i;
    (void)handover.put(test_frame.snapshot());
  }
  PendingData pending;
  handover.take(pending, true, true);
  CHECK(rowCount(pending) == 5000);
  CHECK(pending.events.size() == 100);
  CHECK(pending.events.back().frame == 49990);
  CHECK(pending.template_images.size() == 16);
}

TEST_CASE("with every frame shown, the run waits until each has been taken") {
  Handover handover(true);
  std::vector<std::int64_t> seen;
  std::int64_t taken = 0;
  std::thread run([&] {
    for (std::int64_t i = 0; i < 200; ++i) taken += handover.put(TestFrame(i, false).snapshot());
  });
  PendingData pending;
  while (seen.size() < 200) {
    handover.take(pending, true, true);
    if (pending.has_frame) seen.push_back(pending.newest.frame);
  }
  run.join();
  CHECK(taken == 200);
  for (std::size_t i = 0; i < seen.size(); ++i) REQUIRE(seen[i] == static_cast<std::int64_t>(i));
}

TEST_CASE("close() ends waiting") {
  Handover handover(true);
  (void)handover.put(TestFrame(0).snapshot());
  bool taken = true;
  std::thread run([&] { taken = handover.put(TestFrame(1).snapshot()); });
  handover.close();
  run.join();
  CHECK_FALSE(taken);
}

}  // namespace tolman::web_viewer
