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

/// Of each table, the sum of 64-bit hashes of its rows modulo 2^64. It does not depend on the order
/// of rows, so a replaced row changes it by the difference of two hashes. Detects damage and edits,
/// but not forgery: it is not cryptographic.
class RowSums {
 public:
  /// Of no rows, in the tables of schema() but `run`.
  RowSums();
  /// Of the rows that the database now has; reads all of them.
  static RowSums of(const Database& database);

  /// A row with the hash `row` was written to the table or removed from it; other tables are
  /// ignored.
  void add(const char* table, std::uint64_t row);
  void remove(const char* table, std::uint64_t row);
  /// A row was written whose values are not known, because memory is short.
  void lose() { is_lost_ = true; }
  /// `frame=0123456789abcdef motion=...`. Throws SQLite::Exception if a row was lost.
  std::string text() const;

 private:
  std::uint64_t* sumOf(const char* table);

  // Not static: when a plugin calls exit(), statics are destroyed while rows are still written.
  std::vector<std::string> tables_;
  std::vector<std::uint64_t> sums_;
  bool is_lost_ = false;
};

/// Updates `sums` with every row that the connection `database` writes from now on; `sums` must
/// exist as long as it writes. Does not follow a rollback: the caller then restores `sums`.
void followWrites(sqlite3* database, RowSums& sums);

/// Whether the record has sums; those of earlier versions have none.
bool hasRowSums(const Database& database);
/// Throws BadRow with the first of these tables (empty: all) whose rows are not those of the sums,
/// and reads no other rows; a record without sums is accepted.
void requireRowSums(const Database& database, std::span<const std::string_view> tables = {});

}  // namespace tolman::record
