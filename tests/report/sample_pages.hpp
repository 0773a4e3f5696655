// SPDX-License-Identifier: BSD-3-Clause
// A recorded run with places, cells and truth, for the tests of reports.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>

#include "record/sample_run.hpp"
#include "report/figures.hpp"

namespace tolman::test {

/// How often a part occurs in a text, overlaps included.
inline int countOf(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Unit i of `units` stands for i turns / units.
inline ArrayInfo ringInfo(int units) {
  ArrayAxis heading{"heading", "deg", 0, 360.0 / units, 360, {}};
  return {"hd.activity", ArrayKind::Activity, "", "head direction", "", {heading}};
}

/// Units over one period of the plane, m.
inline ArrayInfo sheetInfo(int side, double period) {
  const double step = period / side;
  return {"grid.activity",
          ArrayKind::Activity,
          "",
          "grid",
          "",
          {{"x", "m", 0, step, period, {}}, {"y", "m", 0, step, period, {}}}};
}

/// Straight ahead at 1 m a frame; the truth is 1 cm farther at every odd frame, times
/// `truth_scale`. Every second view
/// is novel. A ring of 4 units and a sheet of 3x3 fire; array `noise` has no
/// description.
inline void recordRichRun(const std::filesystem::path& folder, std::int64_t frames,
                          const std::string& name, double truth_scale = 1) {
  auto recorder = record::Recorder::open(folder).value();
  RunInfo run;
  run.arrays = {test::ringInfo(4), test::sheetInfo(3, 30)};
  REQUIRE(recorder->begin(run).isOk());
  REQUIRE(recorder->meta("name", name).isOk());
  for (std::int64_t i = 0; i < frames; ++i) {
    Frame frame = frameAt(i);
    frame.has_truth = true;
    frame.T_world_camera_truth.translation().z() =
        truth_scale * (static_cast<double>(i) + (i % 2 == 1 ? 0.01 : 0));
    const Motion motion = motionAt(i);
    PlaceObservation place;
    place.frame = i;
    place.stamp_ns = frame.stamp_ns;
    place.recognition = i % 2 == 0 ? Recognition::Novel : Recognition::Familiar;
    place.template_id = i / 2;
    Decision decision;
    decision.frame = i;
    decision.stamp_ns = frame.stamp_ns;
    decision.experience = 0;
    MapUpdate update;
    update.frame = i;
    update.stamp_ns = frame.stamp_ns;
    update.experience = 0;
    update.T_experience_camera.translation().z() = static_cast<double>(i);
    const MapGraph graph{0, {experienceAt(0, 0, 0)}, {}, {}};
    const std::vector<NamedArray> cells = {
        {"hd.activity", {4}, {1, 0, 0.5F, 0}},
        {"grid.activity", {3, 3}, {1, 0, 0, 0.25F, 0, 0, 0, 0, 0}},
        {"noise", {2}, {0, static_cast<float>(i)}}};
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.motion = &motion;
    snapshot.place = &place;
    snapshot.decision = &decision;
    snapshot.map = &update;
    snapshot.cells = &cells;
    snapshot.graph = i == 0 ? &graph : nullptr;
    REQUIRE(recorder->snapshot(snapshot).isOk());
    REQUIRE(recorder->timing(i, "odometry", 2'000'000).isOk());
  }
  REQUIRE(recorder->close().isOk());
}

/// The page of a recorded run, evaluated by the default settings with seed 1.
inline Result<report::RunPage> pageOf(const std::filesystem::path& folder) {
  const auto reader = record::RunReader::open(folder);
  if (!reader.isOk()) return reader.status();
  auto data = report::readRun(*reader.value(), {}, 1);
  if (!data.isOk()) return data.status();
  return report::makePage(folder, std::move(data).value());
}

}  // namespace tolman::test
