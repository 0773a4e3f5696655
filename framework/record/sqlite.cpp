// SPDX-License-Identifier: BSD-3-Clause
#include "record/sqlite.hpp"

#include <sqlite3.h>

#include <stdexcept>
#include <string>
#include <system_error>

#include "record/descriptor_limit.hpp"
#include "record/file_size_limit.hpp"

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

/// The address of a file that SQLite takes for one that never changes, and reads without its log.
std::string immutable(const std::filesystem::path& file) {
  std::string address = "file:";
  for (const char c : std::filesystem::absolute(file).string()) {
    if (c == '%' || c == '?' || c == '#') {
      address += c == '%' ? "%25" : c == '?' ? "%3f" : "%23";
    } else {
      address += c;
    }
  }
  return address + "?immutable=1";
}

/// Rolls back the unfinished transaction of a killed writer, which a read-only connection cannot
/// do. If that fails (read-only media), the reader fails as well with the reason.
void rollBackJournal(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file.string() + "-journal", ignored)) return;
  Database database(file.string(), SQLite::OPEN_READWRITE, kBusyTimeoutMs);
  (void)database.tryExec("SELECT count(*) FROM sqlite_master");
}

}  // namespace

Status explained(const std::string& where, const SQLite::Exception& error) {
  const int code = error.getErrorCode();
  const bool write_failed = code == SQLITE_FULL || code == SQLITE_IOERR || code == SQLITE_CANTOPEN;
  const bool damaged = code == SQLITE_CORRUPT || code == SQLITE_NOTADB;
  if (code == SQLITE_CANTOPEN && areDescriptorsShort(kFilesOfDatabase)) {
    return Status::failed(where + ": " + error.what() + kMoreDescriptors);
  }
  return {damaged ? StatusCode::InvalidInput : StatusCode::Failed,
          where + ": " + error.what() + remedy(code) + (write_failed ? fileSizeLimit() : "")};
}

Database openDatabase(const std::filesystem::path& file, Access access) {
  const int mode = access == Access::Create  ? SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE
                   : access == Access::Write ? SQLite::OPEN_READWRITE
                                             : SQLite::OPEN_READONLY;
  if (file.native().size() > kLongestDatabasePath) {
    throw std::runtime_error("its path has " + std::to_string(file.native().size()) +
                             " bytes, and SQLite opens " + std::to_string(kLongestDatabasePath) +
                             "; move it, or enter a folder on the way to it");
  }
  if (access == Access::ReadOnly) rollBackJournal(file);
  const bool has_log = access != Access::WithoutLog;
  Database database(has_log ? file.string() : immutable(file),
                    mode | SQLite::OPEN_FULLMUTEX | (has_log ? 0 : SQLite::OPEN_URI),
                    kBusyTimeoutMs);
  database.exec(
      "PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON; PRAGMA foreign_keys = ON; "
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
