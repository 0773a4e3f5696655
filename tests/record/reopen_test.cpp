// SPDX-License-Identifier: BSD-3-Clause
// A record that is opened again has the same contents as one without interruption.
#include <SQLiteCpp/SQLiteCpp.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "record/sample_run.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

/// Frames first ... end - 1, each with a revision of the one before and points of every second.
void recordFrames(Recorder& recorder, std::int64_t first, std::int64_t end) {
  for (std::int64_t i = first; i < end; ++i) {
    const Frame frame = test::frameAt(i);
    Motion motion = test::motionAt(i);
    motion.points_frame = i - i % 2;
    motion.points = decltype(motion.points)::Constant(motion.points.rows(), 3,
                                                      static_cast<float>(motion.points_frame));
    if (i > 0) motion.revisions.push_back({i - 1, motion.T_previous_current, Matrix6d::Zero()});
    MapGraph graph;
    for (std::int64_t id = 0; id <= i; ++id) {
      graph.experiences.push_back(test::experienceAt(id, id, 0.5 * static_cast<double>(i)));
      if (id > 0) graph.links.push_back(test::linkBetween(id - 1, id - 1, id, id));
    }
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.motion = &motion;
    snapshot.graph = &graph;
    REQUIRE(recorder.snapshot(snapshot).isOk());
    REQUIRE(recorder.timing(i, "map", 7).isOk());
  }
}

void begin(Recorder& recorder) {
  RunInfo run;
  run.source.rig.width = 640;
  REQUIRE(recorder.begin(run).isOk());
}

void finish(Recorder& recorder, std::int64_t frames) {
  REQUIRE(recorder.revisions({{1, Eigen::Isometry3d::Identity(), Matrix6d::Zero()}}).isOk());
  REQUIRE(recorder.finalPoses({{0, Eigen::Isometry3d::Identity()}}).isOk());
  MapGraph graph;
  for (std::int64_t id = 0; id < frames; ++id) {
    graph.experiences.push_back(test::experienceAt(id, id, 1));
  }
  REQUIRE(recorder.graph(graph).isOk());
  REQUIRE(recorder.close().isOk());
}

/// All rows of all tables as text, in the order of writing.
std::string tablesOf(const std::filesystem::path& folder) {
  SQLite::Database database((folder / "run.sqlite").string());
  std::string text;
  for (const Table& table : schema()) {
    text += table.name + "\n";
    SQLite::Statement rows(database, "SELECT * FROM \"" + table.name + "\" ORDER BY rowid");
    while (rows.executeStep()) {
      for (int i = 0; i < rows.getColumnCount(); ++i) text += rows.getColumn(i).getString() + "|";
      text += "\n";
    }
  }
  return text;
}

}  // namespace

TEST_CASE("recorded up to any frame and opened again at an earlier one, the record is the same") {
  constexpr std::int64_t kFrames = 9;
  const test::TemporaryFolder whole;
  {
    auto recorder = Recorder::open(whole.path()).value();
    REQUIRE(recorder->recordForReplay(0).isOk());
    REQUIRE(recorder->session({0, 0, "run", "made up"}).isOk());
    begin(*recorder);
    recordFrames(*recorder, 0, kFrames);
    finish(*recorder, kFrames);
  }
  const std::int64_t reached = GENERATE(5, 9);
  const std::int64_t next = GENERATE(1, 4, 5);
  const bool finished = GENERATE(false, true);  // an interrupted run writes its end
  const test::TemporaryFolder folder;
  {
    auto recorder = Recorder::open(folder.path()).value();
    REQUIRE(recorder->recordForReplay(0).isOk());
    REQUIRE(recorder->session({0, 0, "run", "made up"}).isOk());
    begin(*recorder);
    recordFrames(*recorder, 0, reached);
    if (finished) finish(*recorder, reached);
    REQUIRE((finished || recorder->sync().isOk()));
  }
  auto recorder = Recorder::reopen(folder.path(), next).value();
  begin(*recorder);
  recordFrames(*recorder, next, kFrames);
  finish(*recorder, kFrames);
  CHECK(tablesOf(folder.path()) == tablesOf(whole.path()));
}

TEST_CASE("what cannot be opened again says so") {
  const test::TemporaryFolder folder;
  CHECK_FALSE(Recorder::reopen(folder.path(), 1).isOk());
  std::ofstream(folder.path() / "run.sqlite") << "no database";
  const auto damaged = Recorder::reopen(folder.path(), 1);
  REQUIRE_FALSE(damaged.isOk());
  CHECK(damaged.status().message().find("run.sqlite") != std::string::npos);
}
