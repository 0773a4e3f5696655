// SPDX-License-Identifier: BSD-3-Clause
// Rows against what the records say.
#include "history_row.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "drive.hpp"

namespace tolman::web_viewer {
namespace {

std::map<std::string_view, double> named(const HistoryRow& row) {
  std::map<std::string_view, double> values;
  for (std::size_t i = 0; i < kColumns; ++i) values[kRowColumns[i].name] = row[i];
  return values;
}

}  // namespace

TEST_CASE("a row has the frame's numbers") {
  RowMaker maker;
  (void)maker.next(test::Moment(0).snapshot());
  const test::Moment moment(1);
  auto row = named(maker.next(moment.snapshot()));
  CHECK(row.size() == kColumns);  // no name twice
  CHECK(row["frame"] == 1);
  CHECK(row["stamp_s"] == Approx(1.1));
  CHECK(row["tracking"] == 1);
  CHECK(row["v"] == Approx(10));
  CHECK(row["omega"] == Approx(0).margin(1e-12));
  CHECK(row["tracked"] == 301);
  CHECK(row["keyframe"] == 0);
  CHECK(row["map_z"] == 1.5);
  CHECK(row["recognition"] == 2);
  CHECK(row["template_id"] == 0);
  CHECK(row["score"] == 0.125);
  CHECK(row["action"] == 0);
  CHECK(row["experience"] == 0);
  CHECK(row["heading"] == 0.25);
  CHECK(row["confidence"] == 1);
  CHECK(row["experiences"] == 1);
  CHECK(row["links"] == 0);
  CHECK(row["loops"] == 0);
  CHECK(row["map_version"] == 0);
  CHECK(row["source_ms"] == Approx(1));
  CHECK(row["odometry_ms"] == Approx(2));
  CHECK(std::isnan(row["place_ms"]));  // a stage that was not measured
  CHECK(row["cells_ms"] == Approx(4));
  CHECK(row["map_ms"] == Approx(5));
}

TEST_CASE("odometry is chained, and the truth moved into its world") {
  RowMaker maker;
  test::Moment turn(1);
  turn.motion.T_previous_current = fromPlanar({2, 1, 0.5});
  Eigen::Isometry3d T_truth_start = fromPlanar({3, -4, 1});
  test::Moment start(0);
  start.frame.T_world_camera_truth = T_truth_start;
  turn.frame.T_world_camera_truth = T_truth_start * turn.motion.T_previous_current;
  test::Moment ahead(2);
  ahead.frame.T_world_camera_truth =
      turn.frame.T_world_camera_truth * ahead.motion.T_previous_current;
  auto first = named(maker.next(start.snapshot()));
  CHECK(first["odo_x"] == 0);
  CHECK(first["truth_z"] == Approx(0).margin(1e-12));
  (void)maker.next(turn.snapshot());
  auto row = named(maker.next(ahead.snapshot()));
  // By hand: 2 ahead and 1 to the left, then 1 m along the heading of 0.5 rad.
  CHECK(row["odo_z"] == Approx(2 + std::cos(0.5)));
  CHECK(row["odo_x"] == Approx(-1 - std::sin(0.5)));
  CHECK(row["truth_z"] == Approx(row["odo_z"]));
  CHECK(row["truth_x"] == Approx(row["odo_x"]));
  CHECK(row["truth_y"] == Approx(0).margin(1e-12));
}

TEST_CASE("what is not known is NaN") {
  RowMaker maker;
  Frame frame;
  frame.frame = 7;
  Snapshot bare;
  bare.frame = &frame;
  auto row = named(maker.next(bare));
  CHECK(row["frame"] == 7);
  int unknown = 0;
  for (const auto& [name, value] : row) unknown += std::isnan(value) ? 1 : 0;
  CHECK(unknown == kColumns - 2);
  PlaceObservation nothing;
  bare.place = &nothing;
  row = named(maker.next(bare));
  CHECK(row["recognition"] == 0);
  CHECK(row["template_id"] == -1);
  CHECK(std::isnan(row["score"]));  // of no view
}

}  // namespace tolman::web_viewer
