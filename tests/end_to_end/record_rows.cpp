// SPDX-License-Identifier: BSD-3-Clause
#include "end_to_end/record_rows.hpp"

#include <sqlite3.h>

#include <catch2/catch.hpp>

namespace tolman::test {

std::vector<std::vector<double>> recordRows(const std::filesystem::path& run,
                                            const std::string& query) {
  sqlite3* database = nullptr;
  REQUIRE(sqlite3_open_v2((run / "run.sqlite").c_str(), &database, SQLITE_OPEN_READONLY, nullptr) ==
          SQLITE_OK);
  sqlite3_stmt* statement = nullptr;
  REQUIRE(sqlite3_prepare_v2(database, query.c_str(), -1, &statement, nullptr) == SQLITE_OK);
  std::vector<std::vector<double>> rows;
  while (sqlite3_step(statement) == SQLITE_ROW) {
    std::vector<double>& row = rows.emplace_back();
    for (int column = 0; column < sqlite3_column_count(statement); ++column) {
      row.push_back(sqlite3_column_double(statement, column));
    }
  }
  sqlite3_finalize(statement);
  sqlite3_close(database);
  return rows;
}

void editRecord(const std::filesystem::path& run, const std::string& statement) {
  sqlite3* database = nullptr;
  REQUIRE(sqlite3_open((run / "run.sqlite").c_str(), &database) == SQLITE_OK);
  REQUIRE(sqlite3_exec(database, statement.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK);
  sqlite3_close(database);
}

}  // namespace tolman::test
