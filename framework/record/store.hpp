// SPDX-License-Identifier: BSD-3-Clause
// Writes records to tables, nested lists included. Throws on errors. The caller manages
// transactions.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "record/schema.hpp"

namespace tolman::record {

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
