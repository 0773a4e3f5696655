// SPDX-License-Identifier: BSD-3-Clause
// The SQLite wrapper: values are read as written, and failures have messages.
#include "record/sqlite.hpp"

#include "record/by_hand.hpp"
#include "record/columns.hpp"
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

TEST_CASE("a lack of memory is told as such, not as a fault of the file") {
  const Status status = guarded("run.sqlite", [] { throw std::bad_alloc(); });
  CHECK(status.message() == "run.sqlite: out of memory");
  const auto no_thread = std::make_error_code(std::errc::resource_unavailable_try_again);
  CHECK(guarded("run.sqlite", [&] { throw std::system_error(no_thread); }).message() ==
        "run.sqlite: Resource temporarily unavailable (pthread_create has failed)");
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

TEST_CASE("a reader rolls back what a killed writer has left unfinished") {
  const test::TemporaryFolder folder;
  Database writer = openDatabase(folder.path() / "a", Access::Create);
  writer.exec(
      "PRAGMA cache_size = 2; CREATE TABLE t (i, text);"
      "WITH RECURSIVE n (i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 500)"
      "INSERT INTO t SELECT i, hex(zeroblob(1000)) FROM n");
  writer.exec("BEGIN; UPDATE t SET text = 'new'");  // more than the cache holds: partly in the file
  for (const char* suffix : {"", "-journal"}) {
    std::filesystem::copy(folder.path() / (std::string("a") + suffix),
                          folder.path() / (std::string("killed") + suffix));
  }
  Database reader = openDatabase(folder.path() / "killed", Access::ReadOnly);
  Statement rows(reader, "SELECT count(*), sum(text = 'new') FROM t");
  REQUIRE(rows.step());
  CHECK(rows.next().getInt64() == 500);
  CHECK(rows.next().getInt64() == 0);
}

TEST_CASE("exceptions become a Status whose code and text name the cause") {
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
