// SPDX-License-Identifier: BSD-3-Clause
// Connections and statements of SQLite, on top of SQLiteCpp; values are bound and read from left to
// right. guarded() converts exceptions to a Status with a remedy.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <filesystem>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "tolman/status.hpp"

namespace tolman::record {

using SQLite::Database;

/// A value in the database violates the schema.
class BadRow : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class Access : std::uint8_t { Create, Write, ReadOnly };
/// One connection. Not thread-safe.
Database openDatabase(const std::filesystem::path& file, Access access);

/// A prepared statement.
class Statement : public SQLite::Statement {
 public:
  using SQLite::Statement::Statement;

  /// Binds the next parameter. No argument binds NULL, a std::string a text, pointer and size a
  /// BLOB.
  template <class... Value>
  void bindNext(const Value&... value) {
    bind(++parameter_, value...);
  }
  /// Moves to the next row; false after the last one. Then, and after an exception, the statement
  /// can be bound again.
  bool step();
  /// Executes a statement that has no rows.
  void run() { (void)step(); }
  /// The next column of the row.
  SQLite::Column next() { return getColumn(column_++); }

 private:
  void restart();
  int parameter_ = 0;
  int column_ = 0;
};

/// The message of SQLite with a remedy; InvalidInput if the database is damaged, otherwise Failed.
Status explained(const std::string& where, const SQLite::Exception& error);

/// Calls `work` and converts exceptions to a Status whose message begins with `where`.
template <class Work>
Status guarded(const std::string& where, Work&& work) {
  try {
    work();
    return Status::ok();
  } catch (const BadRow& error) {
    return Status::invalidInput(where + ": " + error.what());
  } catch (const SQLite::Exception& error) {
    return explained(where, error);
  } catch (const std::bad_alloc&) {
    return Status::failed(where + ": out of memory");
  } catch (const std::exception& error) {
    return Status::failed(where + ": " + error.what());
  }
}

/// The result of `work`, or its exception as a Status.
template <class Work>
Result<std::invoke_result_t<Work>> answered(const std::string& where, Work&& work) {
  std::optional<std::invoke_result_t<Work>> answer;
  const Status status = guarded(where, [&] { answer = work(); });
  if (!status.isOk()) return status;
  return *std::move(answer);
}

}  // namespace tolman::record
