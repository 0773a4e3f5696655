// SPDX-License-Identifier: BSD-3-Clause
// The SQLite wrapper: values are read as written, and failures have messages.
#include "base/sqlite.hpp"

#include "record/by_hand.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

TEST_CASE("values of each type come back as they went in") {
  Database database = openDatabase(":memory:", Access::Create);
  database.exec("CREATE TABLE t (i, r, s, b, n)");
  const std::string blob("\0\xff\7", 3);
  Statement insert(database, "INSERT INTO t VALUES (?, ?, ?, ?, ?)");
  insert.bindNext(std::int64_t{INT64_MIN});
  insert.bindNext(5e-324);  // the smallest double
  insert.bindNext(std::string("a\0b \xc3\xa4", 6));
  insert.bindNext(static_cast<const void*>(blob.data()), 3);
  insert.bindNext();
  insert.run();

  Statement rows(database, "SELECT * FROM t");
  REQUIRE(rows.step());
  CHECK(rows.next().getInt64() == INT64_MIN);
  CHECK(rows.next().getDouble() == 5e-324);
  CHECK(rows.next().getString() == std::string("a\0b \xc3\xa4", 6));
  CHECK(rows.next().getString() == blob);
  CHECK(rows.next().isNull());
  CHECK_FALSE(rows.step());
}

TEST_CASE("nothing is written into the folder for temporary files, which can be full") {
  Database database = openDatabase(":memory:", Access::Create);
  Statement place(database, "PRAGMA temp_store");
  REQUIRE(place.step());
  CHECK(place.next().getInt64() == 2);  // memory
}

TEST_CASE("empty text and an empty matrix are not NULL") {
  Database database = openDatabase(":memory:", Access::Create);
  database.exec("CREATE TABLE t (s TEXT NOT NULL, b BLOB NOT NULL)");
  Statement insert(database, "INSERT INTO t VALUES (?, ?)");
  insert.bindNext(std::string());
  Codec<Eigen::RowVectorXf>::bind(insert, Eigen::RowVectorXf());
  insert.run();
  Statement rows(database, "SELECT typeof(s) || length(s) || typeof(b) || length(b) FROM t");
  REQUIRE(rows.step());
  CHECK(rows.next().getString() == "text0blob0");
}

TEST_CASE("a statement that has ended, or failed, can be bound afresh") {
  Database database = openDatabase(":memory:", Access::Create);
  database.exec("CREATE TABLE t (i INTEGER PRIMARY KEY)");
  Statement insert(database, "INSERT INTO t VALUES (?)");
  for (const std::int64_t value : {1, 2}) {
    insert.bindNext(value);
    insert.run();
  }
  insert.bindNext(std::int64_t{2});
  try {
    insert.run();
    FAIL("a key was taken twice");
  } catch (const SQLite::Exception& error) {
    CHECK(explained("f", error).message() == "f: UNIQUE constraint failed: t.i");
  }
  insert.bindNext(std::int64_t{3});
  insert.run();
  Statement sum(database, "SELECT group_concat(i) FROM t");
  REQUIRE(sum.step());
  CHECK(sum.next().getString() == "1,2,3");
}

TEST_CASE("an error of SQLite becomes a message with a remedy") {
  const test::TemporaryFolder folder;
  const auto refusal = [](auto work) { return guarded("", work).message(); };
  CHECK(refusal([&] { openDatabase(folder.path() / "absent", Access::ReadOnly); }) ==
        ": unable to open database file; check path, permissions and free space");
  std::ofstream(folder.path() / "letter") << std::string(2000, 'x');
  Database letter = openDatabase(folder.path() / "letter", Access::ReadOnly);
  CHECK(refusal([&] { letter.exec("SELECT * FROM sqlite_schema"); }) ==
        ": file is not a database; the file is damaged or is no run database");
  Database database = openDatabase(":memory:", Access::Create);
  CHECK(refusal([&] { Statement(database, "SELEKT 1"); }) == ": near \"SELEKT\": syntax error");
}

TEST_CASE("a reader cannot write, and foreign keys are watched") {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "run.sqlite";
  {
    Database writer = openDatabase(file, Access::Create);
    writer.exec("CREATE TABLE a (i INTEGER PRIMARY KEY); CREATE TABLE b (i REFERENCES a (i))");
    CHECK_THROWS_WITH(writer.exec("INSERT INTO b VALUES (1)"), "FOREIGN KEY constraint failed");
  }
  Database reader = openDatabase(file, Access::ReadOnly);
  CHECK(guarded("file", [&] { reader.exec("INSERT INTO a VALUES (1)"); }).message() ==
        "file: attempt to write a readonly database; check path, permissions and free space");
}

TEST_CASE("exceptions become a Status whose code and text name the cause") {
  CHECK(guarded("file", [] {}).isOk());
  const Status bad = guarded("file", [] { throw std::domain_error("is bent"); });
  CHECK(bad.code() == StatusCode::InvalidInput);
  CHECK(bad.message() == "file: is bent");
  const Status failed = guarded("file", [] { throw std::bad_alloc(); });
  CHECK(failed.code() == StatusCode::Failed);

  CHECK(answered("file", [] { return std::string("yes"); }).value() == "yes");
  const Result<int> none = answered("file", []() -> int { throw std::domain_error("is bent"); });
  CHECK(none.status().message() == "file: is bent");
}
