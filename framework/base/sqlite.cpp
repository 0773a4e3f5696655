// SPDX-License-Identifier: BSD-3-Clause
#include "base/sqlite.hpp"

#include <sqlite3.h>

namespace tolman::record {
namespace {

constexpr int kBusyTimeoutMs = 5000;

const char* remedy(int code) {
  switch (code) {
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
      return "; check path, permissions and free space";
    case SQLITE_BUSY:
      return "; another program holds the database";
    default:
      return "";
  }
}

}  // namespace

Status explained(const std::string& where, const SQLite::Exception& error) {
  const int code = error.getErrorCode();
  const bool damaged = code == SQLITE_CORRUPT || code == SQLITE_NOTADB;
  return {damaged ? StatusCode::InvalidInput : StatusCode::Failed,
          where + ": " + error.what() + remedy(code)};
}

Database openDatabase(const std::filesystem::path& file, Access access) {
  const int mode = access == Access::Create  ? SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE
                   : access == Access::Write ? SQLite::OPEN_READWRITE
                                             : SQLite::OPEN_READONLY;
  Database database(file.string(), mode | SQLite::OPEN_FULLMUTEX, kBusyTimeoutMs);
  database.exec(
      "PRAGMA foreign_keys = ON; "
      "PRAGMA temp_store = MEMORY");  // else a full folder for temporary files ends a run
  return database;
}

bool Statement::step() {
  column_ = 0;
  try {
    if (executeStep()) return true;
  } catch (...) {
    restart();
    throw;
  }
  restart();
  return false;
}

void Statement::restart() {
  (void)tryReset();  // repeats the error of the last step, which has been reported
  clearBindings();
  parameter_ = 0;
}

}  // namespace tolman::record
