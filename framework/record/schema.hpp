// SPDX-License-Identifier: BSD-3-Clause
// The tables of run.sqlite: one per kind of record, generated from its field list, and a few that
// hold no records. All are STRICT; columns are NOT NULL where nothing else is said.
#pragma once

#include <string>
#include <vector>

#include "record/columns.hpp"
#include "tolman/records.hpp"

namespace tolman::record {

inline constexpr std::int64_t kSchemaVersion = 5;

struct Table {
  std::string name;
  std::string doc;
  Columns columns;
  std::string constraints;  ///< SQL after the columns, with a leading comma
};

/// Parents of foreign keys come first.
std::vector<Table> schema();

std::string createSql(const Table& table);

/// `"a", "b"`: quoted, because link.from and link.to are words of SQL.
std::string columnList(const Columns& columns);

/// INSERT for `columns` with one `?` each.
std::string insertSql(const std::string& table, const Columns& columns);

/// The column of a table of nested records that holds the frame of the enclosing record.
Column announcedAt();

}  // namespace tolman::record
