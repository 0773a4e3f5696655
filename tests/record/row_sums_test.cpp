// SPDX-License-Identifier: BSD-3-Clause
// Rows of an unfinished record that were edited, added or removed are noticed; what a recorder
// writes, replaces, rolls back and writes again is not.
#include "record/row_sums.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>

#include "record/by_hand.hpp"
#include "record/export.hpp"
#include "record/run_reader.hpp"
#include "record/sample_run.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

/// Frame `i` with sensors, cells, a revision, a growing map that moves, and its computing time.
void recordAll(Recorder& recorder, std::int64_t i) {
  Frame frame = test::frameAt(i);
  frame.sensors = {{"wheel", {2}, {1.5F, -0.0F}}};
  Motion motion = test::motionAt(i);
  motion.T_previous_current.translation().x() = i % 2 == 0 ? -0.0 : 0.1;
  if (i > 0) motion.revisions.push_back({i - 1, motion.T_previous_current, Matrix6d::Zero()});
  const std::vector<NamedArray> cells = {{"hd", {3}, {1, 2, NAN}}};
  MapGraph graph;
  for (std::int64_t id = 0; id <= i; ++id) {
    graph.experiences.push_back(test::experienceAt(id, id, 0.3 * static_cast<double>(i * id)));
    if (id > 0) graph.links.push_back(test::linkBetween(id - 1, id - 1, id, id));
  }
  if (i == 3) graph.links.pop_back();  // a map may remove links
  Snapshot snapshot;
  snapshot.frame = &frame;
  snapshot.motion = &motion;
  snapshot.graph = &graph;
  snapshot.cells = &cells;
  REQUIRE(recorder.snapshot(snapshot).isOk());
  REQUIRE(recorder.timing(i, "map", 7).isOk());
  REQUIRE(recorder.event(i, LogLevel::Info, "map", "t\xc3\xa4xt").isOk());
}

std::unique_ptr<Recorder> killedRun(const std::filesystem::path& folder) {
  auto recorder = Recorder::open(folder).value();
  REQUIRE(recorder->session({0, 0, "run", "made up"}).isOk());
  REQUIRE(recorder->begin({}).isOk());
  for (std::int64_t i = 0; i < 5; ++i) recordAll(*recorder, i);
  REQUIRE(recorder->commit().isOk());
  return recorder;
}

std::string refusal(const std::filesystem::path& folder) {
  const auto reader = RunReader::open(folder);
  return reader.isOk() ? "" : reader.status().message();
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("edited rows of a killed run are detected and name the table; undone edits are not") {
  const std::vector<std::pair<std::string, std::string>> edits = {
      {"motion", "UPDATE motion SET T_previous_current_z = 2 WHERE frame = 2"},
      {"motion", "UPDATE motion SET state = 'lost' WHERE frame = 2"},
      {"motion_revision", "DELETE FROM motion_revision WHERE frame = 3"},
      {"array", "DELETE FROM array WHERE frame = 1 AND source = 'cells'"},
      {"array", "UPDATE array SET \"values\" = zeroblob(8) WHERE source = 'sensors' AND frame = 4"},
      {"timing", "DELETE FROM timing WHERE frame = 0"},
      {"timing", "INSERT INTO timing SELECT * FROM timing WHERE frame = 0"},
      {"experience", "UPDATE experience SET T_world_experience_z = 9 WHERE id = 1"},
      {"link", "UPDATE link SET weight = 0.5 WHERE id = 0"},
      {"event", "UPDATE event SET message = 'text' WHERE frame = 2"},
      {"session", "UPDATE session SET source = 'other'"},
      {"camera_rig", "DELETE FROM rig"},
  };
  for (auto [table, edit] : edits) {
    if (table == "camera_rig") {
      table = CameraRig::kRecord;
      edit = "DELETE FROM \"" + table + "\"";
    }
    const test::TemporaryFolder folder;
    auto recorder = killedRun(folder.path());
    INFO(edit);
    REQUIRE(refusal(folder.path()).empty());
    test::queryByHand(folder.path(), edit);
    CHECK(contains(refusal(folder.path()),
                   "/run.sqlite: the rows of table '" + table +
                       "' are not those that the run wrote: they were changed, added or removed"));
    const auto again = Recorder::reopen(folder.path(), 3);
    REQUIRE_FALSE(again.isOk());
    CHECK(contains(again.status().message(), "the rows of table '" + table + "'"));
  }
}

TEST_CASE("only the tables that are asked for are compared, of a run that ended") {
  const test::TemporaryFolder folder;
  REQUIRE(killedRun(folder.path())->close().isOk());
  test::queryByHand(folder.path(), "UPDATE timing SET duration_ns = 1");
  const auto reader = RunReader::open(folder.path()).value();
  CHECK_FALSE(reader->rowsWereCompared());
  CHECK(checkRows(*reader, std::array<std::string_view, 2>{"link", "motion"}).isOk());
  CHECK(contains(std::string(checkRows(*reader).message()), "the rows of table 'timing'"));
  const std::array<std::string_view, 2> with_it = {"link", "timing"};
  CHECK(contains(std::string(checkRows(*reader, with_it).message()), "table 'timing'"));
}

TEST_CASE("a change that is taken back, and a compacted file, are the record that it was") {
  const test::TemporaryFolder folder;
  auto recorder = killedRun(folder.path());
  test::queryByHand(folder.path(), "UPDATE timing SET duration_ns = duration_ns + 1");
  CHECK_FALSE(refusal(folder.path()).empty());
  test::queryByHand(folder.path(), "UPDATE timing SET duration_ns = duration_ns - 1");
  CHECK(refusal(folder.path()).empty());
  test::queryByHand(folder.path(), "VACUUM");
  CHECK(refusal(folder.path()).empty());
}

TEST_CASE("calls that are undone, and records that are opened again, keep the sums") {
  const test::TemporaryFolder folder;
  {
    auto recorder = killedRun(folder.path());
    const Frame twice = test::frameAt(2);
    Snapshot snapshot;
    snapshot.frame = &twice;
    CHECK_FALSE(recorder->snapshot(snapshot).isOk());
    MapGraph graph{1, {test::experienceAt(0, 0, 8), test::experienceAt(1, 77, 8)}, {}, {}};
    CHECK_FALSE(recorder->graph(graph).isOk());  // frame 77 is missing: experience 0 is undone
    recordAll(*recorder, 5);
    REQUIRE(recorder->commit().isOk());
    CHECK(refusal(folder.path()).empty());
  }
  auto recorder = Recorder::reopen(folder.path(), 3).value();
  CHECK(recorder->rowsWereCompared());
  CHECK(refusal(folder.path()).empty());
  for (std::int64_t i = 3; i < 7; ++i) recordAll(*recorder, i);
  REQUIRE(recorder->commit().isOk());
  CHECK(refusal(folder.path()).empty());
  test::queryByHand(folder.path(), "UPDATE link SET weight = 0.5 WHERE id = 1");
  CHECK(contains(refusal(folder.path()), "'link'"));
}

TEST_CASE("a record of an earlier version, without sums, is read and reopened, and reports it") {
  const test::TemporaryFolder folder;
  killedRun(folder.path());
  test::queryByHand(folder.path(),
                    "DELETE FROM run WHERE key IN ('row_sums', 'rows');"
                    "UPDATE timing SET duration_ns = 1");
  CHECK(refusal(folder.path()).empty());
  auto recorder = Recorder::reopen(folder.path(), 3).value();
  CHECK_FALSE(recorder->rowsWereCompared());
  CHECK(refusal(folder.path()).empty());
  test::queryByHand(folder.path(), "UPDATE timing SET duration_ns = 2");
  CHECK_FALSE(refusal(folder.path()).empty());  // from then on
}

TEST_CASE("a record of 4,000 frames is compared within a fraction of a second", "[.cost]") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  const auto since = [](auto start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const std::vector<NamedArray> cells = {{"a", {36}, std::vector<float>(36)},
                                         {"b", {20, 20, 36}, std::vector<float>(14400)}};
  auto start = std::chrono::steady_clock::now();
  for (std::int64_t i = 0; i < 4000; ++i) {
    const Frame frame = test::frameAt(i);
    const Motion motion = test::motionAt(i);
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.motion = &motion;
    snapshot.cells = &cells;
    REQUIRE(recorder->snapshot(snapshot).isOk());
  }
  REQUIRE(recorder->commit().isOk());
  WARN("recorded in " << since(start) << " s");
  start = std::chrono::steady_clock::now();
  REQUIRE(RunReader::open(folder.path()).isOk());
  WARN("opened in " << since(start) << " s");
}
