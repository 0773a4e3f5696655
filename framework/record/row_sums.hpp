// SPDX-License-Identifier: BSD-3-Clause
// For each table of run.sqlite a sum over its rows, kept while they are written, from which a
// reader of an unfinished run tells rows that were changed, added or removed after the run.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "record/sqlite.hpp"

struct sqlite3;

namespace tolman::record {

/// In table `run`: the RowSums of the rows at the last commit.
inline constexpr const char* kRowSumsKey = "row_sums";

/// Sums of 64 bits of each row modulo 2^64. They do not depend on the order of rows, so a row that
/// is replaced needs only itself. They notice damage and edits, and are no signature.
class RowSums {
 public:
  /// Of no rows, in the tables of schema() but `run`.
  RowSums();
  /// Of the rows that the database now has; reads all of them.
  static RowSums of(const Database& database);

  /// `row` is written to the table or taken away; other tables are ignored.
  void add(const char* table, std::uint64_t row);
  void remove(const char* table, std::uint64_t row);
  /// `frame=0123456789abcdef motion=...`
  std::string text() const;

 private:
  std::uint64_t* sumOf(const char* table);

  // Not static: when a plugin calls exit(), statics are destroyed while rows are still written.
  std::vector<std::string> tables_;
  std::vector<std::uint64_t> sums_;
};

/// Keeps `sums` to what the connection `database` writes from now on. Both must outlive it.
/// A rollback is not seen: the caller then restores `sums`.
void followWrites(sqlite3* database, RowSums& sums);

/// Whether the record has sums; those of earlier versions have none.
bool hasRowSums(const Database& database);
/// Throws BadRow with the first of these tables (empty: all) whose rows are not those of the sums,
/// and reads no other rows; a record without sums is accepted.
void requireRowSums(const Database& database, std::span<const std::string_view> tables = {});

}  // namespace tolman::record
