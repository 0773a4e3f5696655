// SPDX-License-Identifier: BSD-3-Clause
// SQLite with owners and exceptions; the only place that knows its C interface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "tolman/status.hpp"

struct sqlite3;
struct sqlite3_stmt;

namespace tolman::record {

/// SQLite refused; what() is a sentence for a person.
class SqliteError : public std::runtime_error {
 public:
  SqliteError(int code, const std::string& message) : std::runtime_error(message), code_(code) {}
  /// The statement was wrong for these data (a broken rule of the schema); the file is well.
  bool isConstraint() const;

 private:
  int code_;
};

/// A value in the database is not what the schema promises.
class BadRow : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One connection. Not for two threads at once.
class Database {
 public:
  enum class Mode : std::uint8_t { Create, ReadOnly };
  Database(const std::filesystem::path& file, Mode mode);

  void execute(const std::string& sql);
  sqlite3* handle() const { return handle_.get(); }

 private:
  struct Close {
    void operator()(sqlite3* handle) const;
  };
  std::unique_ptr<sqlite3, Close> handle_;
};

/// A prepared statement. Values are bound and columns are read from left to right.
class Statement {
 public:
  Statement(const Database& database, const std::string& sql);

  void bind(std::int64_t value);
  void bind(double value);
  void bind(std::string_view value);
  void bind(std::span<const std::byte> value);
  void bindNull();

  /// Moves to the next row; false after the last, and the statement can then be bound afresh.
  bool step();
  /// Executes a statement that has no rows.
  void run();
  /// Back to before the first row, nothing bound.
  void reset();

  bool isNull() const;  ///< of the next column; does not move on
  std::int64_t integer();
  double real();
  std::string text();
  std::vector<std::byte> blob();
  void skip() { ++column_; }

 private:
  void check(int code) const;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  std::unique_ptr<sqlite3_stmt, Finalize> handle_;
  int parameter_ = 0;
  int column_ = 0;
};

/// Calls `work` and turns what it throws into a Status; `where` starts the message.
template <class Work>
Status guarded(const std::string& where, Work&& work) {
  try {
    work();
    return Status::ok();
  } catch (const BadRow& error) {
    return Status::invalidInput(where + ": " + error.what());
  } catch (const std::exception& error) {
    return Status::failed(where + ": " + error.what());
  }
}

/// What `work` answers, or what it throws as a failure.
template <class Work>
Result<std::invoke_result_t<Work>> answered(const std::string& where, Work&& work) {
  std::optional<std::invoke_result_t<Work>> answer;
  const Status status = guarded(where, [&] { answer = work(); });
  if (!status.isOk()) return status;
  return *std::move(answer);
}

}  // namespace tolman::record
