// SPDX-License-Identifier: BSD-3-Clause
// Writes records to tables and reads them, nested lists included. Throws on errors. The caller
// manages transactions.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "record/schema.hpp"

namespace tolman::record {

template <class T>
inline constexpr bool kIsRecordList = false;
template <Record R>
inline constexpr bool kIsRecordList<std::vector<R>> = true;

/// Prepares each statement once.
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
      columns.insert(columns.begin(), announcedAt());
      return insertSql(R::kRecord, columns);
    });
    frame ? row.bindNext(*frame) : row.bindNext();
    Codec<R>::bind(row, record);
    row.run();
  }

  void insertArrays(std::int64_t frame, std::string_view source,
                    const std::vector<NamedArray>& arrays);

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
  static std::string upsertSql(const std::string& table, const Columns& columns);

  Database& database_;
  std::map<std::string, Statement, std::less<>> statements_;
};

struct RecordedArray;
/// The array of a row. Throws BadRow if the shape does not fit the values.
NamedArray arrayOf(const RecordedArray& row);
/// The arrays of a frame, by name.
std::vector<NamedArray> readArrays(const Database& database, std::int64_t frame,
                                   std::string_view source);

template <Record R>
void readLists(const Database& database, R& record);

/// Calls visit(const R&) for each row, with nested lists filled, in the order of rowid: that of the
/// key if it is one integer (frame, id), otherwise the order of insertion.
template <Record R, class Visit>
void forEachRow(const Database& database, const std::string& condition, Visit&& visit) {
  Statement rows(database, "SELECT " + columnList(columnsOf<R>()) + " FROM \"" + R::kRecord +
                               "\" " + condition + " ORDER BY rowid");
  while (rows.step()) {
    R record;
    Codec<R>::read(rows, record);
    readLists(database, record);
    visit(record);
  }
}

template <Record R>
void readLists(const Database& database, R& record) {
  if constexpr (requires { record.frame; }) {  // only records with a frame have lists
    visitFields(record, [&]([[maybe_unused]] const Field& field, auto& value) {
      using T = std::remove_cvref_t<decltype(value)>;
      if constexpr (std::is_same_v<T, std::vector<NamedArray>>) {
        value = readArrays(database, record.frame, field.name);
      } else if constexpr (kIsRecordList<T>) {
        const std::string announced = "WHERE \"announced_at\" = " + std::to_string(record.frame);
        forEachRow<typename T::value_type>(database, announced,
                                           [&](const auto& item) { value.push_back(item); });
      }
    });
  }
}

}  // namespace tolman::record
