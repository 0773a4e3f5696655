// SPDX-License-Identifier: BSD-3-Clause
// The tables of run.sqlite: one per kind of record, generated from its field list, and a few that
// hold no records. All are STRICT; columns are NOT NULL where nothing else is said. Views for
// queries by hand have poses in the plane, and no column names that are words of SQL.
#pragma once

#include <string>
#include <vector>

#include "base/record_rows.hpp"

namespace tolman::record {

struct Table {
  std::string name;
  std::string doc;
  Columns columns;
  std::string constraints;  ///< SQL after the columns, with a leading comma
};

/// Parents of foreign keys come first.
std::vector<Table> schema();

std::string createSql(const Table& table);

/// INSERT for `columns` with one `?` each.
std::string insertSql(const std::string& table, const Columns& columns);

/// The same, and all columns are replaced where the table has a row of this id.
std::string upsertSql(const std::string& table, const Columns& columns);

/// The column of a table of nested records that holds the frame of the enclosing record.
Column announcedAt();

struct SqlView {
  std::string name;
  std::string doc;
  std::string select;
};

std::vector<SqlView> views();

std::string createSql(const SqlView& view);

/// The reference page, Markdown: every table, column, type, unit and meaning.
std::string recordsMarkdown();

}  // namespace tolman::record
