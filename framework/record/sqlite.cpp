// SPDX-License-Identifier: BSD-3-Clause
#include "record/sqlite.hpp"

#include <sqlite3.h>

namespace tolman::record {
namespace {

constexpr int kBusyTimeoutMs = 5000;

std::string remedy(int code) {
  switch (code & 0xff) {
    case SQLITE_FULL:
      return "; free some space on the disk";
    case SQLITE_IOERR:
      return "; look for a full disk, a quota or a failing device";
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return "; the file is damaged or is no run database";
    case SQLITE_CANTOPEN:
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return "; check that the path exists and its permissions";
    case SQLITE_BUSY:
      return "; another program holds the database";
    default:
      return "";
  }
}

[[noreturn]] void fail(sqlite3* handle, int code) {
  const char* text = handle != nullptr ? sqlite3_errmsg(handle) : sqlite3_errstr(code);
  throw SqliteError(code, text + remedy(code));
}

}  // namespace

bool SqliteError::isConstraint() const { return (code_ & 0xff) == SQLITE_CONSTRAINT; }

void Database::Close::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }

Database::Database(const std::filesystem::path& file, Mode mode) {
  const int flags =
      (mode == Mode::Create ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY) |
      SQLITE_OPEN_FULLMUTEX;
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(file.c_str(), &handle, flags, nullptr);
  handle_.reset(handle);
  if (code != SQLITE_OK) fail(handle, code);
  sqlite3_extended_result_codes(handle, 1);
  sqlite3_busy_timeout(handle, kBusyTimeoutMs);
  execute("PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON; PRAGMA foreign_keys = ON");
}

void Database::execute(const std::string& sql) {
  const int code = sqlite3_exec(handle(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(handle(), code);
}

void Statement::Finalize::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Statement::Statement(const Database& database, const std::string& sql) {
  sqlite3_stmt* handle = nullptr;
  const int code = sqlite3_prepare_v3(database.handle(), sql.c_str(), -1, SQLITE_PREPARE_PERSISTENT,
                                      &handle, nullptr);
  if (code != SQLITE_OK) fail(database.handle(), code);
  handle_.reset(handle);
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) fail(sqlite3_db_handle(handle_.get()), code);
}

void Statement::bind(std::int64_t value) {
  check(sqlite3_bind_int64(handle_.get(), ++parameter_, value));
}

void Statement::bind(double value) {
  check(sqlite3_bind_double(handle_.get(), ++parameter_, value));
}

void Statement::bind(std::string_view value) {
  const char* data = value.data() != nullptr ? value.data() : "";
  check(sqlite3_bind_text64(handle_.get(), ++parameter_, data, value.size(), SQLITE_TRANSIENT,
                            SQLITE_UTF8));
}

void Statement::bind(std::span<const std::byte> value) {
  static constexpr std::byte kNothing{};  // a null pointer would bind NULL
  check(sqlite3_bind_blob64(handle_.get(), ++parameter_, value.empty() ? &kNothing : value.data(),
                            value.size(), SQLITE_TRANSIENT));
}

void Statement::bindNull() { check(sqlite3_bind_null(handle_.get(), ++parameter_)); }

bool Statement::step() {
  const int code = sqlite3_step(handle_.get());
  column_ = 0;
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) {
    const SqliteError error(code, sqlite3_errmsg(sqlite3_db_handle(handle_.get())) + remedy(code));
    reset();
    throw error;
  }
  reset();
  return false;
}

void Statement::run() {
  while (step()) {
  }
}

void Statement::reset() {
  sqlite3_reset(handle_.get());  // repeats the error of step(), which has been reported
  sqlite3_clear_bindings(handle_.get());
  parameter_ = 0;
}

bool Statement::isNull() const {
  return sqlite3_column_type(handle_.get(), column_) == SQLITE_NULL;
}

std::int64_t Statement::integer() { return sqlite3_column_int64(handle_.get(), column_++); }

double Statement::real() { return sqlite3_column_double(handle_.get(), column_++); }

std::string Statement::text() {
  const auto* data = reinterpret_cast<const char*>(sqlite3_column_text(handle_.get(), column_));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column_++));
  return data != nullptr ? std::string(data, size) : std::string();
}

std::vector<std::byte> Statement::blob() {
  const auto* data = static_cast<const std::byte*>(sqlite3_column_blob(handle_.get(), column_));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column_++));
  return data != nullptr ? std::vector<std::byte>(data, data + size) : std::vector<std::byte>();
}

}  // namespace tolman::record
