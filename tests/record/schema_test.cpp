// SPDX-License-Identifier: BSD-3-Clause
// The tables as SQLite has them, and the page that describes them.
#include "record/schema.hpp"

#include <map>

#include "record/by_hand.hpp"
#include "record/recorder.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

/// A run without rows.
struct EmptyRun {
  test::TemporaryFolder folder;
  EmptyRun() {
    REQUIRE(Recorder::open(folder.path()).value()->recordForReplay(0).isOk());  // all tables
  }
  std::vector<std::string> query(const std::string& sql) const {
    return test::queryByHand(folder.path(), sql);
  }
};

/// The cells of `| a | b |`.
std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t from = 2; from < line.size();) {
    const std::size_t to = line.find(" |", from);
    cells.push_back(line.substr(from, to - from));
    from = to + 3;
  }
  return cells;
}

/// The page read back: rows of cells by table.
std::map<std::string, std::vector<std::vector<std::string>>> tablesOf(const std::string& page) {
  std::map<std::string, std::vector<std::vector<std::string>>> tables;
  std::string table;
  for (const std::string& line : test::linesOf(page)) {
    if (line.starts_with("## ")) table = line.substr(3);
    if (line.starts_with("| `")) tables[table].push_back(cellsOf(line));
  }
  return tables;
}

}  // namespace

TEST_CASE("the database has exactly the declared tables and columns") {
  const EmptyRun run;
  for (const Table& table : schema()) {
    std::vector<std::string> names;
    for (const Column& column : table.columns) names.push_back(column.name);
    const std::string sql = "SELECT name FROM pragma_table_info('" + table.name + "')";
    CHECK(run.query(sql) == names);
  }
  CHECK(run.query("SELECT count(*) FROM sqlite_schema WHERE type = 'table'") ==
        std::vector<std::string>{std::to_string(schema().size())});
}

TEST_CASE("the reference page names every table, column, unit and meaning") {
  const std::string page = recordsMarkdown();
  for (const Table& table : schema()) CHECK(page.find("\n## " + table.name + "\n") < page.size());
  CHECK(page.find("| `stamp_ns` | INTEGER | ns | data time of the exposure |\n") < page.size());
  CHECK(page.find("| `covariance` | BLOB | m^2, m rad, rad^2 | covariance, translation before "
                  "rotation; 6x6 "
                  "float64, row-major |\n") < page.size());
  CHECK(page.find("| `points` | BLOB | px, px, 1/m, 1/m^2 | columns of u, v, inverse depth, its "
                  "variance; 4xn "
                  "float32, row-major |\n") < page.size());
}

TEST_CASE("the reference page, read back, is what SQLite says of the file") {
  const EmptyRun run;
  const auto tables = tablesOf(recordsMarkdown());
  CHECK(run.query("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name").size() ==
        tables.size());
  for (const auto& [table, rows] : tables) {
    INFO(table);
    const auto columns = run.query("SELECT name, type, \"notnull\" FROM pragma_table_info('" +
                                   table + "') ORDER BY cid");
    REQUIRE(columns.size() == rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      REQUIRE(rows[i].size() == 4);
      const bool may_be_null = rows[i][1].ends_with(" NULL");
      const std::string type = rows[i][1].substr(0, rows[i][1].find(' '));
      const std::string name = rows[i][0].substr(1, rows[i][0].size() - 2);
      CHECK(columns[i] == name + "|" + type + "|" + (may_be_null ? "0" : "1"));
      CHECK_FALSE(rows[i][3].empty());
    }
  }
}

TEST_CASE("rows refer to what exists: foreign keys by table") {
  const EmptyRun run;
  const auto keys = [&](const std::string& table) {
    std::string text;
    for (const std::string& row :
         run.query("SELECT \"from\" || ' -> ' || \"table\" || '.' || \"to\" FROM"
                   " pragma_foreign_key_list('" +
                   table + "') ORDER BY 1")) {
      text += row + "; ";
    }
    return text;
  };
  for (const char* table : {"motion", "place", "candidate", "decision", "hypothesis", "map_update",
                            "experience", "array"}) {
    INFO(table);
    CHECK(keys(table) == "frame -> frame.frame; ");
  }
  CHECK(keys("link") == "frame -> frame.frame; from -> experience.id; to -> experience.id; ");
  for (const char* table : {"motion_revision", "earlier_loop"}) {
    CHECK(keys(table) == "announced_at -> frame.frame; frame -> frame.frame; ");
  }
  for (const char* table : {"frame", "camera", "timing", "event", "run"})
    CHECK(keys(table).empty());
}

TEST_CASE("tables are strict: no text where a number belongs, no NULL where a value belongs") {
  const EmptyRun run;
  Database database = openDatabase(run.folder.path() / "run.sqlite", Access::Create);
  CHECK_THROWS_WITH(database.exec("INSERT INTO timing VALUES ('one', 'map', 1)"),
                    "cannot store TEXT value in INTEGER column timing.frame");
  CHECK_THROWS_WITH(database.exec("INSERT INTO timing VALUES (1, NULL, 1)"),
                    "NOT NULL constraint failed: timing.stage");
  database.exec("INSERT INTO timing VALUES (1, 'map', 1)");
}

TEST_CASE("names that are words of SQL are quoted") {
  const Columns columns = {{"from", "INTEGER", "", ""}, {"to", "TEXT NULL", "", ""}};
  CHECK(columnList(columns) == "\"from\", \"to\"");
  CHECK(insertSql("link", columns) == "INSERT INTO \"link\" (\"from\", \"to\") VALUES (?, ?)");
  CHECK(createSql({"link", "", columns, ", PRIMARY KEY (\"from\")"}) ==
        "CREATE TABLE \"link\" (\"from\" INTEGER NOT NULL, \"to\" TEXT NULL, PRIMARY KEY "
        "(\"from\")) STRICT");
}
