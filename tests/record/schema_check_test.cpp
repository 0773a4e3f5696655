// SPDX-License-Identifier: BSD-3-Clause
// Records that others have changed: with triggers, with views in place of tables, and with rows
// removed.
#include "record/schema_check.hpp"

#include <catch2/catch.hpp>

#include "record/recorder.hpp"
#include "record/run_reader.hpp"
#include "record/sample_run.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

/// A run of five frames, after `sql`.
std::filesystem::path changedRun(const test::TemporaryFolder& folder, const std::string& sql) {
  auto recorder = Recorder::open(folder.path()).value();
  for (std::int64_t i = 0; i < 5; ++i) REQUIRE(test::recordFrame(*recorder, i).isOk());
  REQUIRE(recorder->close().isOk());
  recorder.reset();
  Database database = openDatabase(folder.path() / "run.sqlite", Access::Write);
  database.exec("PRAGMA foreign_keys = OFF");
  database.exec(sql);
  return folder.path();
}

std::string refusal(const std::string& sql) {
  const test::TemporaryFolder folder;
  const auto reader = RunReader::open(changedRun(folder, sql));
  if (reader.isOk()) return "";
  CHECK(reader.status().code() == StatusCode::InvalidInput);
  return reader.status().message();
}

}  // namespace

TEST_CASE("a run as it was recorded is read, with views of other names") {
  CHECK(refusal("SELECT 1").empty());
  CHECK(refusal("CREATE VIEW mine AS SELECT * FROM frame").empty());
}

TEST_CASE("a view in place of a table is refused before it is read") {
  const std::string endless =
      "ALTER TABLE link RENAME TO links; CREATE VIEW link AS WITH RECURSIVE t(x) AS (SELECT 1 "
      "UNION ALL SELECT x + 1 FROM t) SELECT l.* FROM links l, t";
  CHECK_THAT(refusal(endless), Catch::EndsWith("'link' is a view, and not the table of a run"));
}

TEST_CASE("a trigger is refused, by readers and by a run that would write again") {
  const std::string trigger =
      "CREATE TRIGGER thief AFTER INSERT ON decision BEGIN DELETE FROM decision; END";
  CHECK_THAT(refusal(trigger),
             Catch::EndsWith("has a trigger 'thief', which no run writes; remove it"));
  const test::TemporaryFolder folder;
  const auto recorder = Recorder::reopen(changedRun(folder, trigger), 3);
  REQUIRE_FALSE(recorder.isOk());
  CHECK_THAT(recorder.status().message(), Catch::Contains("has a trigger 'thief'"));
}
