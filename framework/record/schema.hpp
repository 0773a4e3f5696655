// SPDX-License-Identifier: BSD-3-Clause
// The tables of run.sqlite: one a record kind, generated from the record's field list, and four
// that are not records. All are STRICT, all columns NOT NULL unless said.
#pragma once

#include <string>
#include <vector>

#include "record/columns.hpp"
#include "tolman/records.hpp"

namespace tolman::record {

inline constexpr std::int64_t kSchemaVersion = 2;

struct Table {
  std::string name;
  std::string doc;
  Columns columns;
  std::string constraints;  ///< SQL after the columns, with a leading comma
  bool deterministic = true;
};

/// In an order in which they can be created and filled.
std::vector<Table> schema();

std::string createSql(const Table& table);

/// `"a", "b"`: quoted, because link.from and link.to are words of SQL.
std::string columnList(const Columns& columns);

/// INSERT for `columns` with one `?` each.
std::string insertSql(const std::string& table, const Columns& columns);

/// The column of a table of nested records that says with which frame they came.
Column announcedAt();

}  // namespace tolman::record
