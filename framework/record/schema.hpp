// SPDX-License-Identifier: BSD-3-Clause
// The tables of run.sqlite: one per kind of record, generated from its field list, and a few that
// hold no records. All are STRICT; columns are NOT NULL where nothing else is said. Views for
// queries by hand have poses in the plane, and no column names that are words of SQL.
#pragma once

#include <map>
#include <optional>
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

/// The column of a table of nested records that holds the frame of the enclosing record: its name
/// is `frame` where the records have no frame of their own.
template <Record R>
Column nestedIn() {
  if constexpr (requires(R r) { r.frame; }) {
    return {kNestedIn<R>, "INTEGER NULL", "",
            "the frame whose record brought it; NULL after the last frame"};
  } else {
    return {kNestedIn<R>, "INTEGER", "", "the frame"};
  }
}

struct SqlView {
  std::string name;
  std::string doc;
  std::string select;
};

std::vector<SqlView> views();

std::string createSql(const SqlView& view);

/// The reference page, Markdown: every table, column, type, unit and meaning.
std::string recordsMarkdown();

/// Writes records to tables, nested lists included; prepares each statement once. Throws on errors.
/// The caller manages transactions.
class StoreWriter {
 public:
  explicit StoreWriter(Database& database) : database_(database) {}

  template <Record R>
  void insert(const R& record) {
    Statement& row = statement(R::kRecord, [] { return insertSql(R::kRecord, columnsOf<R>()); });
    Codec<R>::bind(row, record);
    row.run();
    insertLists(record);
  }

  /// Inserts, or replaces all columns of the row with the same id.
  template <Record R>
  void upsert(const R& record) {
    Statement& row = statement(R::kRecord, [] { return upsertSql(R::kRecord, columnsOf<R>()); });
    Codec<R>::bind(row, record);
    row.run();
  }

  /// Inserts a row of a nested list. `frame`: frame of the enclosing record; none after the last
  /// frame.
  template <Record R>
  void insertAnnounced(std::optional<std::int64_t> frame, const R& record) {
    Statement& row = statement(R::kRecord, [] {
      Columns columns = columnsOf<R>();
      columns.insert(columns.begin(), nestedIn<R>());
      return insertSql(R::kRecord, columns);
    });
    frame ? row.bindNext(*frame) : row.bindNext();
    Codec<R>::bind(row, record);
    row.run();
  }

  void insertArrays(std::int64_t frame, std::string_view source,
                    const std::vector<NamedArray>& arrays) {
    for (const NamedArray& array : arrays) {
      std::string shape;
      for (const int side : array.shape) shape += (shape.empty() ? "" : "x") + std::to_string(side);
      const auto size = static_cast<Eigen::Index>(array.values.size());
      insert(RecordedArray{frame, std::string(source), array.name, shape,
                           Eigen::Map<const Eigen::RowVectorXf>(array.values.data(), size)});
    }
  }

 private:
  template <Record R>
  void insertLists(const R& record) {
    visitFields(record, [&]([[maybe_unused]] const Field& field, const auto& value) {
      using T = std::remove_cvref_t<decltype(value)>;
      if constexpr (!requires { record.frame; }) {
        static_assert(!StoredElsewhere<T>, "only records with a frame may have lists");
      } else if constexpr (std::is_same_v<T, std::vector<NamedArray>>) {
        insertArrays(record.frame, field.name, value);
      } else if constexpr (kIsRecordList<T>) {
        for (const auto& item : value) insertAnnounced(record.frame, item);
      }
    });
  }

  template <class MakeSql>
  Statement& statement(std::string_view table, MakeSql&& make_sql) {
    const auto found = statements_.find(table);
    if (found != statements_.end()) return found->second;
    return statements_.emplace(table, Statement(database_, make_sql())).first->second;
  }

  Database& database_;
  std::map<std::string, Statement, std::less<>> statements_;
};

}  // namespace tolman::record
