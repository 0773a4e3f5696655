// SPDX-License-Identifier: BSD-3-Clause
// A recorded walk whose ring and grid modules have known errors.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "record/sample_run.hpp"
#include "report/run_data.hpp"
#include "support/data.hpp"

namespace tolman::test {

inline constexpr double kTurn = 2 * std::numbers::pi;
inline constexpr std::int64_t kFrames = 600;

struct Described {
  std::vector<double> periods = {20, 28.4};
  const char* unit = "m";
  bool truth = true;
  bool infos = true;
};

inline ArrayInfo walkRing() {
  return {"hd.activity",
          ArrayKind::Activity,
          "",
          "",
          "",
          {{"heading", "rad", 0, kTurn / 24, kTurn, {}}}};
}

inline ArrayInfo walkSheet(double period, std::size_t module, const char* unit) {
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
inline PlanarPose poseAt(std::int64_t frame) {
  const double t = static_cast<double>(frame) * 0.05;
  const double dx = 30 * std::cos(t);
  const double dy = 30 * std::sqrt(2.0) * std::cos(std::sqrt(2.0) * t);
  return {30 * std::sin(t), 30 * std::sin(std::sqrt(2.0) * t), std::atan2(dy, dx)};
}

inline std::vector<NamedArray> cellsAt(const PlanarPose& pose, const Described& described) {
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
inline void recordWalk(const std::filesystem::path& folder, const Described& described,
                       double heading_error) {
  Eigen::Isometry3d T_truth_map = fromPlanar({100, -50, kTurn / 4});
  auto recorder = record::Recorder::open(folder).value();
  RunInfo run;
  run.arrays = {walkRing()};
  for (std::size_t i = 0; i < described.periods.size(); ++i) {
    run.arrays.push_back(walkSheet(described.periods[i], i, described.unit));
  }
  if (!described.infos) run.arrays.clear();
  REQUIRE(recorder->begin(run).isOk());
  for (std::int64_t i = 0; i < kFrames; ++i) {
    const PlanarPose pose = poseAt(i);
    Frame frame = frameAt(i);
    frame.has_truth = described.truth;
    frame.T_world_camera_truth = T_truth_map * fromPlanar(pose);
    const Motion motion = motionAt(i);
    MapUpdate update;
    update.frame = i;
    update.stamp_ns = frame.stamp_ns;
    update.experience = 0;
    update.T_experience_camera = fromPlanar(pose);
    const MapGraph graph{0, {experienceAt(0, 0, 0)}, {}, {}};
    const auto cells = cellsAt({pose.x, pose.y, pose.theta + heading_error}, described);
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

/// The walk as a report reads it, with seed 3.
inline report::RunData readWalk(const Described& described, double heading_error = 0) {
  const TemporaryFolder folder;
  recordWalk(folder.path(), described, heading_error);
  auto data = report::readRun(*record::RunReader::open(folder.path()).value(), {}, 3);
  INFO(data.status().message());
  REQUIRE(data.isOk());
  return std::move(data).value();
}

}  // namespace tolman::test
