// SPDX-License-Identifier: BSD-3-Clause
// SQLite with owners: what goes in comes out, and failures are sentences.
#include "record/sqlite.hpp"

#include "record/by_hand.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

TEST_CASE("values of each type come back as they went in") {
  Database database(":memory:", Database::Mode::Create);
  database.execute("CREATE TABLE t (i, r, s, b, n)");
  const std::array<std::byte, 3> blob = {std::byte{0}, std::byte{255}, std::byte{7}};
  Statement insert(database, "INSERT INTO t VALUES (?, ?, ?, ?, ?)");
  insert.bind(std::int64_t{INT64_MIN});
  insert.bind(5e-324);  // the smallest double
  insert.bind(std::string_view("a\0b \xc3\xa4", 6));
  insert.bind(std::span<const std::byte>(blob));
  insert.bindNull();
  insert.run();

  Statement rows(database, "SELECT * FROM t");
  REQUIRE(rows.step());
  CHECK(rows.integer() == INT64_MIN);
  CHECK(rows.real() == 5e-324);
  CHECK(rows.text() == std::string("a\0b \xc3\xa4", 6));
  CHECK(rows.blob() == std::vector<std::byte>(blob.begin(), blob.end()));
  CHECK(rows.isNull());
  CHECK_FALSE(rows.step());
}

TEST_CASE("empty is not NULL") {
  Database database(":memory:", Database::Mode::Create);
  database.execute("CREATE TABLE t (s TEXT NOT NULL, b BLOB NOT NULL)");
  Statement insert(database, "INSERT INTO t VALUES (?, ?)");
  insert.bind(std::string_view());
  insert.bind(std::span<const std::byte>());
  insert.run();
  Statement rows(database, "SELECT typeof(s) || length(s) || typeof(b) || length(b) FROM t");
  REQUIRE(rows.step());
  CHECK(rows.text() == "text0blob0");
}

TEST_CASE("a statement that has ended, or failed, can be bound afresh") {
  Database database(":memory:", Database::Mode::Create);
  database.execute("CREATE TABLE t (i INTEGER PRIMARY KEY)");
  Statement insert(database, "INSERT INTO t VALUES (?)");
  for (const std::int64_t value : {1, 2}) {
    insert.bind(value);
    insert.run();
  }
  insert.bind(std::int64_t{2});
  try {
    insert.run();
    FAIL("a key was taken twice");
  } catch (const SqliteError& error) {
    CHECK(error.isConstraint());
    CHECK(std::string(error.what()) == "UNIQUE constraint failed: t.i");
  }
  insert.bind(std::int64_t{3});
  insert.run();
  Statement sum(database, "SELECT group_concat(i) FROM t");
  REQUIRE(sum.step());
  CHECK(sum.text() == "1,2,3");
}

TEST_CASE("what SQLite refuses is said with the remedy") {
  const test::TemporaryFolder folder;
  CHECK_THROWS_WITH(Database(folder.path() / "absent", Database::Mode::ReadOnly),
                    "unable to open database file; check that the path exists and its permissions");
  std::ofstream(folder.path() / "letter") << std::string(2000, 'x');
  Database letter(folder.path() / "letter", Database::Mode::ReadOnly);
  CHECK_THROWS_WITH(letter.execute("SELECT * FROM sqlite_schema"),
                    "file is not a database; the file is damaged or is no run database");
  Database database(":memory:", Database::Mode::Create);
  CHECK_THROWS_WITH(Statement(database, "SELEKT 1"), "near \"SELEKT\": syntax error");
}

TEST_CASE("a reader cannot write, and foreign keys are watched") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "run.sqlite";
  {
    Database writer(file, Database::Mode::Create);
    writer.execute("CREATE TABLE a (i INTEGER PRIMARY KEY); CREATE TABLE b (i REFERENCES a (i))");
    CHECK_THROWS_WITH(writer.execute("INSERT INTO b VALUES (1)"), "FOREIGN KEY constraint failed");
  }
  Database reader(file, Database::Mode::ReadOnly);
  CHECK_THROWS_WITH(
      reader.execute("INSERT INTO a VALUES (1)"),
      "attempt to write a readonly database; check that the path exists and its permissions");
}

TEST_CASE("exceptions become a Status that says whose fault it is") {
  CHECK(guarded("file", [] {}).isOk());
  const Status bad = guarded("file", [] { throw BadRow("is bent"); });
  CHECK(bad.code() == StatusCode::InvalidInput);
  CHECK(bad.message() == "file: is bent");
  const Status failed = guarded("file", [] { throw std::bad_alloc(); });
  CHECK(failed.code() == StatusCode::Failed);

  CHECK(answered("file", [] { return std::string("yes"); }).value() == "yes");
  const Result<int> none = answered("file", []() -> int { throw BadRow("is bent"); });
  CHECK(none.status().message() == "file: is bent");
}
