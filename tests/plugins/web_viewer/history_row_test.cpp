// SPDX-License-Identifier: BSD-3-Clause
// History rows compared with the records.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "watched_run.hpp"
#include "wire_records.hpp"

namespace tolman::web_viewer {
namespace {

/// The next row, by the names of its columns.
std::map<std::string, double> nextRow(RowMaker& maker, const Snapshot& snapshot) {
  std::vector<double> row;
  maker.append(snapshot, row);
  REQUIRE(row.size() == rowColumns().size());
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < row.size(); ++i) values[rowColumns()[i].name] = row[i];
  REQUIRE(values.size() == row.size());  // no name twice
  return values;
}

}  // namespace

TEST_CASE("a row has the values of the records") {
  RowMaker maker;
  (void)nextRow(maker, test::TestFrame(0).snapshot());
  const test::TestFrame test_frame(1);
  auto row = nextRow(maker, test_frame.snapshot());
  CHECK(row["frame.frame"] == 1);
  CHECK(row["frame.time"] == Approx(1.1));
  CHECK(row["motion.state"] == 1);
  CHECK(row["motion.v"] == Approx(10));
  CHECK(row["motion.omega"] == Approx(0).margin(1e-12));
  CHECK(row["motion.tracked"] == 301);
  CHECK(row["motion.is_keyframe"] == 0);
  CHECK(row["map.z"] == 1.5);
  CHECK(row["place.recognition"] == 2);
  CHECK(row["place.template_id"] == 0);
  CHECK(row["place.score"] == 0.125);
  CHECK(row["decision.action"] == 0);
  CHECK(row["decision.experience"] == 0);
  CHECK(row["decision.heading"] == 0.25);
  CHECK(row["decision.confidence"] == 1);
  CHECK(row["map_update.experiences"] == 1);
  CHECK(row["map_update.links"] == 0);
  CHECK(row["map_update.loops"] == 0);
  CHECK(row["map_update.version"] == 0);
  CHECK(row["duration.source"] == Approx(1));
  CHECK(row["duration.odometry"] == Approx(2));
  CHECK(std::isnan(row["duration.place"]));  // a stage that was not measured
  CHECK(row["duration.cells"] == Approx(4));
  CHECK(row["duration.map"] == Approx(5));
}

TEST_CASE("a row has the best candidate, the hypothesis of the view, and the anchor of the pose") {
  RowMaker maker;
  test::TestFrame frame(4);
  frame.place.candidates = {{3, 0.25, 0.5, 7, 9, 12, ""}, {1, 0.75, 0.5, -1, -1, -1, ""}};
  PlaceHypothesis faded, grown;
  faded.fate = Fate::Faded;
  grown.id = 5;
  grown.fate = Fate::Grew;
  grown.share = 0.75;
  frame.decision.hypotheses = {faded, grown};
  frame.map.T_experience_camera = fromPlanar({2, 0, 0});
  frame.map.T_world_camera = fromPlanar({5, 1, 0.5}) * frame.map.T_experience_camera;
  auto row = nextRow(maker, frame.snapshot());
  CHECK(row["candidate.template_id"] == 3);
  CHECK(row["candidate.limit"] == 0.5);
  CHECK(row["candidate.needed"] == 12);
  CHECK(row["hypothesis.id"] == 5);
  CHECK(row["hypothesis.share"] == 0.75);
  CHECK(row["anchor.z"] == Approx(5));
  CHECK(row["anchor.x"] == Approx(-1));
  CHECK(row["anchor.yaw"] == Approx(0.5));
  row = nextRow(maker, test::TestFrame(5).snapshot());
  CHECK(std::isnan(row["candidate.score"]));
  CHECK(std::isnan(row["hypothesis.id"]));
  CHECK(std::isnan(row["measured.error"]));
}

TEST_CASE("a measured pose is compared with the true one, where the truth turns") {
  RowMaker maker;
  test::TestFrame made(0), seen(1);
  made.frame.T_world_camera_truth = fromPlanar({3, -4, 1});
  const Eigen::Isometry3d T_true = fromPlanar({2, 1, 0.5});
  seen.frame.T_world_camera_truth = made.frame.T_world_camera_truth * T_true;
  seen.place.has_relative_pose = true;
  seen.place.T_template_current = T_true * fromPlanar({0.6, 0, 0});
  seen.place.covariance = 0.04 * Matrix6d::Identity();
  (void)nextRow(maker, made.snapshot());
  auto row = nextRow(maker, seen.snapshot());
  CHECK(row["measured.error"] == Approx(0.6));
  CHECK(row["measured.sigmas"] == Approx(3));
}

TEST_CASE("odometry is chained, and the truth transformed to its world") {
  RowMaker maker;
  test::TestFrame turn(1);
  turn.motion.T_previous_current = fromPlanar({2, 1, 0.5});
  Eigen::Isometry3d T_truth_start = fromPlanar({3, -4, 1});
  test::TestFrame start(0);
  start.frame.T_world_camera_truth = T_truth_start;
  turn.frame.T_world_camera_truth = T_truth_start * turn.motion.T_previous_current;
  test::TestFrame ahead(2);
  ahead.frame.T_world_camera_truth =
      turn.frame.T_world_camera_truth * ahead.motion.T_previous_current;
  auto first = nextRow(maker, start.snapshot());
  CHECK(first["odometry.x"] == 0);
  CHECK(first["truth.z"] == Approx(0).margin(1e-12));
  (void)nextRow(maker, turn.snapshot());
  auto row = nextRow(maker, ahead.snapshot());
  // By hand: 2 ahead and 1 to the left, then 1 m along the heading of 0.5 rad.
  CHECK(row["odometry.z"] == Approx(2 + std::cos(0.5)));
  CHECK(row["odometry.x"] == Approx(-1 - std::sin(0.5)));
  CHECK(row["truth.z"] == Approx(row["odometry.z"]));
  CHECK(row["truth.x"] == Approx(row["odometry.x"]));
  CHECK(row["truth.y"] == Approx(0).margin(1e-12));
}

TEST_CASE("unknown values are NaN") {
  RowMaker maker;
  Frame frame;
  frame.frame = 7;
  Snapshot bare;
  bare.frame = &frame;
  auto row = nextRow(maker, bare);
  CHECK(row["frame.frame"] == 7);
  const std::set<std::string> known = {"frame.frame", "frame.time", "frame.source_index",
                                       "frame.has_truth"};
  for (const auto& [name, value] : row) {
    INFO(name);
    CHECK(std::isnan(value) == !known.contains(name));
  }
  PlaceObservation nothing;
  bare.place = &nothing;
  row = nextRow(maker, bare);
  CHECK(row["place.recognition"] == 0);
  CHECK(row["place.template_id"] == -1);
}

}  // namespace tolman::web_viewer
