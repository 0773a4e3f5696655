// SPDX-License-Identifier: BSD-3-Clause
#include "record/row_sums.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <new>
#include <set>
#include <sstream>

#include "record/fingerprint.hpp"
#include "record/schema.hpp"

namespace tolman::record {
namespace {

enum class Kind : std::uint8_t { Null, Number, Real, Text, Blob };

/// 64 bits of the values of a row, from left to right.
class RowHash {
 public:
  void add(sqlite3_value* value) {
    switch (sqlite3_value_type(value)) {
      case SQLITE_INTEGER:
        return addInteger(sqlite3_value_int64(value));
      case SQLITE_FLOAT:
        return addReal(sqlite3_value_double(value));
      case SQLITE_TEXT:
        return addBytes(Kind::Text, sqlite3_value_text(value), sqlite3_value_bytes(value));
      case SQLITE_BLOB:
        return addBytes(Kind::Blob, sqlite3_value_blob(value), sqlite3_value_bytes(value));
      default:
        fingerprint_.add(Kind::Null);
    }
  }
  /// Whether SQLite had the memory to give all values.
  bool isWhole() const { return is_whole_; }
  void lose() { is_whole_ = false; }
  std::uint64_t value() const { return fingerprint_.first ^ std::rotl(fingerprint_.second, 32); }

 private:
  void addInteger(std::int64_t value) {
    fingerprint_.add(Kind::Number);
    fingerprint_.add(value);
  }
  /// SQLite may store whole REAL numbers as integers, and passes either to the hook, so both get
  /// the same hash.
  void addReal(double value) {
    constexpr double kExact = 9e15;  // below 2^53, up to which doubles hold every integer
    if (std::abs(value) < kExact && value == std::trunc(value)) {
      return addInteger(static_cast<std::int64_t>(value));
    }
    fingerprint_.add(Kind::Real);
    fingerprint_.add(value);
  }
  void addBytes(Kind kind, const void* bytes, int size) {
    if (bytes == nullptr && size > 0) return lose();
    fingerprint_.add(kind);
    fingerprint_.add(size);
    const char* next = static_cast<const char*>(bytes);
    for (std::size_t left = static_cast<std::size_t>(size); left > 0;) {
      std::uint64_t word = 0;
      const std::size_t taken = std::min(left, sizeof(word));
      std::memcpy(&word, next, taken);
      fingerprint_.add(word);
      next += taken;
      left -= taken;
    }
  }

  Fingerprint fingerprint_;
  bool is_whole_ = true;
};

/// A query whose values can be given to RowHash, which SQLiteCpp does not allow.
class RawStatement {
 public:
  RawStatement(sqlite3* database, const std::string& sql) : database_(database) {
    require(sqlite3_prepare_v2(database, sql.c_str(), -1, &statement_, nullptr), SQLITE_OK);
  }
  ~RawStatement() { sqlite3_finalize(statement_); }
  RawStatement(const RawStatement&) = delete;
  RawStatement& operator=(const RawStatement&) = delete;
  bool step() const {
    const int code = sqlite3_step(statement_);
    if (code != SQLITE_DONE) require(code, SQLITE_ROW);
    return code == SQLITE_ROW;
  }
  sqlite3_stmt* get() const { return statement_; }

 private:
  void require(int code, int wanted) const {
    if (code != wanted) throw SQLite::Exception(database_, code);
  }
  sqlite3* database_;
  sqlite3_stmt* statement_ = nullptr;
};

using ValueOf = int (*)(sqlite3*, int, sqlite3_value**);

RowHash hashOf(sqlite3* database, ValueOf value_of) {
  RowHash hash;
  for (int i = 0; i < sqlite3_preupdate_count(database); ++i) {
    sqlite3_value* value = nullptr;
    const bool is_given = value_of(database, i, &value) == SQLITE_OK && value != nullptr;
    is_given ? hash.add(value) : hash.lose();
  }
  return hash;
}

void onWrite(void* sums, sqlite3* database, int operation, const char* /*schema*/,
             const char* table, sqlite3_int64 /*old_key*/, sqlite3_int64 /*new_key*/) {
  auto& kept = *static_cast<RowSums*>(sums);
  if (std::string_view(table) == "run") return;
  if (operation != SQLITE_INSERT) {
    const RowHash row = hashOf(database, sqlite3_preupdate_old);
    row.isWhole() ? kept.remove(table, row.value()) : kept.lose();
  }
  if (operation != SQLITE_DELETE) {
    const RowHash row = hashOf(database, sqlite3_preupdate_new);
    row.isWhole() ? kept.add(table, row.value()) : kept.lose();
  }
}

std::vector<std::string> tablesWithSums() {
  std::vector<std::string> tables;
  for (const Table& table : schema()) {
    if (table.name != "run") tables.push_back(table.name);
  }
  return tables;
}

std::uint64_t sumOfRows(const Database& database, const std::string& table) {
  const RawStatement rows(database.getHandle(), "SELECT * FROM \"" + table + "\"");
  std::uint64_t sum = 0;
  while (rows.step()) {
    RowHash hash;
    for (int i = 0; i < sqlite3_column_count(rows.get()); ++i) {
      hash.add(sqlite3_column_value(rows.get(), i));
    }
    if (!hash.isWhole()) throw std::bad_alloc();
    sum += hash.value();
  }
  return sum;
}

std::string textOf(const std::string& table, std::uint64_t sum) {
  return fmt::format("{}={:016x}", table, sum);
}

std::string storedSums(const Database& database) {
  Statement row(database, "SELECT \"value\" FROM \"run\" WHERE \"key\" = ?");
  row.bindNext(std::string(kRowSumsKey));
  return row.step() ? row.next().getString() : "";
}

}  // namespace

RowSums::RowSums() : tables_(tablesWithSums()), sums_(tables_.size()) {}

RowSums RowSums::of(const Database& database) {
  RowSums sums;
  for (std::size_t i = 0; i < sums.sums_.size(); ++i) {
    sums.sums_[i] = sumOfRows(database, sums.tables_[i]);
  }
  return sums;
}

std::uint64_t* RowSums::sumOf(const char* table) {
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    if (tables_[i] == table) return &sums_[i];
  }
  return nullptr;
}

void RowSums::add(const char* table, std::uint64_t row) {
  if (std::uint64_t* sum = sumOf(table); sum != nullptr) *sum += row;
}

void RowSums::remove(const char* table, std::uint64_t row) {
  if (std::uint64_t* sum = sumOf(table); sum != nullptr) *sum -= row;
}

std::string RowSums::text() const {
  if (is_lost_) throw SQLite::Exception("out of memory", SQLITE_NOMEM);
  std::string text;
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    text += (i == 0 ? "" : " ") + textOf(tables_[i], sums_[i]);
  }
  return text;
}

void followWrites(sqlite3* database, RowSums& sums) {
  sqlite3_preupdate_hook(database, onWrite, &sums);
}

bool hasRowSums(const Database& database) { return !storedSums(database).empty(); }

void requireRowSums(const Database& database, std::span<const std::string_view> tables) {
  const std::string stored = storedSums(database);
  if (stored.empty()) return;
  std::istringstream sums(stored);
  const std::set<std::string> recorded{std::istream_iterator<std::string>(sums), {}};
  for (const std::string& table : tablesWithSums()) {
    if (!tables.empty() && std::ranges::find(tables, table) == tables.end()) continue;
    if (recorded.contains(textOf(table, sumOfRows(database, table)))) continue;
    throw BadRow("the rows of table '" + table +
                 "' are not those that the run wrote: they were changed, added or removed "
                 "afterwards; run it again, or take back the change");
  }
}

}  // namespace tolman::record
