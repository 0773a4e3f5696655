// SPDX-License-Identifier: BSD-3-Clause
#include "end_to_end/record_rows.hpp"

#include <sqlite3.h>

#include <catch2/catch.hpp>

namespace tolman::test {

namespace {

template <class Cell>
void visitCells(const std::filesystem::path& run, const std::string& query, const Cell& cell) {
  sqlite3* database = nullptr;
  REQUIRE(sqlite3_open_v2((run / "run.sqlite").c_str(), &database, SQLITE_OPEN_READONLY, nullptr) ==
          SQLITE_OK);
  sqlite3_stmt* statement = nullptr;
  REQUIRE(sqlite3_prepare_v2(database, query.c_str(), -1, &statement, nullptr) == SQLITE_OK);
  while (sqlite3_step(statement) == SQLITE_ROW) {
    for (int i = 0; i < sqlite3_column_count(statement); ++i) cell(statement, i);
  }
  sqlite3_finalize(statement);
  sqlite3_close(database);
}

}  // namespace

std::vector<std::vector<double>> recordRows(const std::filesystem::path& run,
                                            const std::string& query) {
  std::vector<std::vector<double>> rows;
  visitCells(run, query, [&](sqlite3_stmt* statement, int column) {
    if (column == 0) rows.emplace_back();
    rows.back().push_back(sqlite3_column_double(statement, column));
  });
  return rows;
}

std::string recordText(const std::filesystem::path& run, const std::string& query) {
  std::string text;
  visitCells(run, query, [&](sqlite3_stmt* statement, int column) {
    const auto* cell = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
    text.append(cell != nullptr ? cell : "NULL").append("|");
  });
  return text;
}

void editRecord(const std::filesystem::path& run, const std::string& statement) {
  sqlite3* database = nullptr;
  REQUIRE(sqlite3_open((run / "run.sqlite").c_str(), &database) == SQLITE_OK);
  REQUIRE(sqlite3_exec(database, statement.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK);
  sqlite3_close(database);
}

}  // namespace tolman::test
