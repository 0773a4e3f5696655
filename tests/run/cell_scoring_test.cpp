// SPDX-License-Identifier: BSD-3-Clause
// A recorded walk whose ring and grid modules are wrong by known amounts.
#include "run/cell_scoring.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "record/sample_run.hpp"
#include "support/data.hpp"

using namespace tolman;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr std::int64_t kFrames = 600;

struct Errors {
  double heading = 0;                                  ///< rad
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< m, after the first frame
};

struct Described {
  std::vector<double> periods = {20, 28.4};
  const char* unit = "m";
  bool truth = true;
  bool infos = true;
};

ArrayInfo ringInfo() {
  return {"hd.activity",
          ArrayKind::Activity,
          "",
          "",
          "",
          {{"heading", "rad", 0, kTurn / 24, kTurn, {}}}};
}

ArrayInfo sheetInfo(double period, std::size_t module, const char* unit) {
  const auto axis = [&](const char* name) {
    return ArrayAxis{name, unit, 0, period / 12, period, {}};
  };
  return {"grid" + std::to_string(module) + ".activity",
          ArrayKind::Activity,
          "",
          "",
          "",
          {axis("y"), axis("x")}};
}

/// A path that winds through a square, with all headings.
PlanarPose poseAt(std::int64_t frame) {
  const double t = static_cast<double>(frame) * 0.05;
  const double dx = 30 * std::cos(t);
  const double dy = 30 * std::sqrt(2.0) * std::cos(std::sqrt(2.0) * t);
  return {30 * std::sin(t), 30 * std::sin(std::sqrt(2.0) * t), std::atan2(dy, dx)};
}

std::vector<NamedArray> cellsAt(const PlanarPose& pose, const Described& described) {
  NamedArray ring{"hd.activity", {24}, {}};
  for (int i = 0; i < 24; ++i) {
    ring.values.push_back(
        static_cast<float>(std::exp(2.4 * (std::cos(pose.theta - i * kTurn / 24) - 1))));
  }
  std::vector<NamedArray> arrays = {ring, {"other", {1}, {1}}};
  for (std::size_t module = 0; module < described.periods.size(); ++module) {
    const double period = described.periods[module];
    NamedArray sheet{"grid" + std::to_string(module) + ".activity", {12, 12}, {}};
    const auto rate = [&](double at, int unit) {
      return std::exp(2 * (std::cos(kTurn * (at / period - unit / 12.0)) - 1));
    };
    for (int row = 0; row < 12; ++row) {
      for (int column = 0; column < 12; ++column) {
        // The code's own origin is (7, 4) away.
        sheet.values.push_back(
            static_cast<float>(rate(pose.y + 4, row) * rate(pose.x + 7, column)));
      }
    }
    arrays.push_back(std::move(sheet));
  }
  return arrays;
}

/// The map is right; the truth is in a frame that is turned by a quarter and shifted.
void recordWalk(const std::filesystem::path& folder, const Described& described,
                const Errors& errors) {
  Eigen::Isometry3d T_truth_map = fromPlanar({100, -50, kTurn / 4});
  auto recorder = record::Recorder::open(folder).value();
  RunInfo run;
  run.arrays = {ringInfo()};
  for (std::size_t i = 0; i < described.periods.size(); ++i) {
    run.arrays.push_back(sheetInfo(described.periods[i], i, described.unit));
  }
  if (!described.infos) run.arrays.clear();
  REQUIRE(recorder->begin(run).isOk());
  for (std::int64_t i = 0; i < kFrames; ++i) {
    const PlanarPose pose = poseAt(i);
    Frame frame = test::frameAt(i);
    frame.has_truth = described.truth;
    frame.T_world_camera_truth = T_truth_map * fromPlanar(pose);
    const Motion motion = test::motionAt(i);
    MapUpdate update;
    update.frame = i;
    update.stamp_ns = frame.stamp_ns;
    update.experience = 0;
    update.T_experience_camera = fromPlanar(pose);
    const MapGraph graph{0, {test::experienceAt(0, 0, 0)}, {}, {}};
    const double wrong = i == 0 ? 0 : 1;
    const auto cells = cellsAt({pose.x + wrong * errors.position.x(),
                                pose.y + wrong * errors.position.y(), pose.theta + errors.heading},
                               described);
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.motion = &motion;
    snapshot.map = &update;
    snapshot.cells = &cells;
    snapshot.graph = i == 0 ? &graph : nullptr;
    REQUIRE(recorder->snapshot(snapshot).isOk());
  }
  REQUIRE(recorder->close().isOk());
}

evaluation::CellFigures scored(const Described& described, const Errors& errors = {}) {
  const test::TemporaryFolder folder;
  recordWalk(folder.path(), described, errors);
  const auto reader = record::RunReader::open(folder.path()).value();
  const auto data = report::readRun(*reader, {}).value();
  const auto cells = run::scoreCells(*reader, data, 3);
  INFO(cells.status().message());
  REQUIRE(cells.isOk());
  REQUIRE(cells.value());
  return *cells.value();
}

}  // namespace

TEST_CASE("right cells have no error, in whatever frame the truth is, and score above chance") {
  const auto cells = scored({});
  CHECK(cells.truth);
  REQUIRE(cells.rings.size() == 1);
  REQUIRE(cells.sheets.size() == 2);
  REQUIRE((cells.rings[0].error_deg && cells.position_m));
  CHECK(cells.rings[0].error_deg->count == kFrames);
  CHECK(cells.rings[0].error_deg->p90 < 0.1);
  CHECK(cells.position_m->p90 < 0.05);
  CHECK(cells.modulo_m == 0);
  CHECK(cells.least_shift_s == Approx(6).epsilon(0.01));  // a tenth of 60 s
  REQUIRE((cells.rings[0].scores.mean_vector_length && cells.sheets[0].scores.square));
  CHECK(cells.rings[0].scores.mean_vector_length->share_above == 1);
  CHECK(cells.sheets[0].scores.square->share_above > 0.8);
  CHECK(cells.sheets[0].units == 144);
}

TEST_CASE("errors are those of ring and modules, also beyond half a period") {
  const auto cells = scored({}, {-kTurn / 4, {15, 8}});
  REQUIRE((cells.rings[0].error_deg && cells.position_m));
  CHECK(cells.rings[0].error_deg->median == Approx(90).margin(0.1));
  CHECK(cells.position_m->median == Approx(17).margin(0.1));
}

TEST_CASE("a single module tells the position modulo its period") {
  const auto cells = scored({{20}}, {0, {23, -20}});
  REQUIRE(cells.position_m);
  CHECK(cells.position_m->median == Approx(3).margin(0.1));
  CHECK(cells.modulo_m == 20);
}

TEST_CASE(
    "without truth there are no errors, and the reason is said; units are scored on the map") {
  const auto cells = scored({{20, 28.4}, "m", false});
  CHECK_FALSE(cells.truth);
  CHECK_FALSE(cells.position_m);
  CHECK_FALSE(cells.rings[0].error_deg);
  CHECK(cells.rings[0].scores.mean_vector_length);
  const auto json = toJson(cells);
  CHECK(json["reason"] == "there is no ground truth");
  CHECK(json["places"] == "map");
  CHECK(json["head_direction"][0]["error"]["median_deg"].is_null());
  CHECK(json["position_error"]["median_m"].is_null());
  CHECK(json["head_direction"][0]["mean_vector_length"]["median"].is_number());
}

TEST_CASE("modules whose axes are not metres tell no position, and the reason is said") {
  const auto json = toJson(scored({{20}, "cells"}));
  CHECK(json["position_error"]["median_m"].is_null());
  CHECK(json["position_error"]["reason"] == "the axes of grid0.activity are in cells, not in m");
  CHECK(json["head_direction"][0]["error"]["median_deg"].is_number());
  CHECK(json["grid"][0]["grid_score_square"]["median"].is_number());
}

TEST_CASE("a run without described activity has no cells") {
  const test::TemporaryFolder folder;
  recordWalk(folder.path(), {{20}, "m", true, false}, {});
  const auto reader = record::RunReader::open(folder.path()).value();
  const auto cells = run::scoreCells(*reader, report::readRun(*reader, {}).value(), 1);
  REQUIRE(cells.isOk());
  CHECK_FALSE(cells.value());
}
