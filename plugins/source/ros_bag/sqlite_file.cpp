// SPDX-License-Identifier: BSD-3-Clause
#include "sqlite_file.hpp"

#include <SQLiteCpp/Statement.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "bag_problems.hpp"
#include "base/open_files.hpp"
#include "compression.hpp"

namespace tolman::ros_bag {
namespace {

constexpr std::size_t kMaxMessageBytes = std::size_t{256} << 20U;  // of an unpacked message

std::vector<std::uint8_t> blobOf(const SQLite::Column& column) {
  const auto* data = static_cast<const std::uint8_t*>(column.getBlob());
  const int size = column.getBytes();
  if (data == nullptr || size <= 0) return {};
  return {data, data + size};
}

/// The message, unpacked if it was compressed; empty if that fails.
std::optional<std::vector<std::uint8_t>> plain(std::vector<std::uint8_t> blob) {
  if (!isZstd(blob)) return blob;
  return unpackZstd(blob, kMaxMessageBytes);
}

std::unique_ptr<SQLite::Database> openPath(const std::filesystem::path& path) {
  try {
    auto database = std::make_unique<SQLite::Database>(path.string(), SQLite::OPEN_READONLY);
    SQLite::Statement(*database, "SELECT count(*) FROM sqlite_master").executeStep();
    return database;
  } catch (const SQLite::Exception& failure) {
    // A database with a journal cannot be opened in a read-only folder.
    if (failure.getErrorCode() != SQLITE_CANTOPEN) throw;
    return std::make_unique<SQLite::Database>("file:" + path.string() + "?immutable=1",
                                              SQLite::OPEN_READONLY | SQLite::OPEN_URI);
  }
}

std::unique_ptr<SQLite::Database> openMemory(Bytes bytes) {
  auto database = std::make_unique<SQLite::Database>(":memory:", SQLite::OPEN_READWRITE);
  auto* data = const_cast<std::uint8_t*>(bytes.data());  // read only, see the flag
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  const int status = sqlite3_deserialize(database->getHandle(), "main", data, size, size,
                                         SQLITE_DESERIALIZE_READONLY);
  if (status != SQLITE_OK) throw SQLite::Exception("cannot be opened in memory", status);
  return database;
}

}  // namespace

bool SqliteFile::isSqlite(FileBytes& file) {
  std::array<std::uint8_t, 16> start{};
  return file.read(0, start) && asText(start).starts_with("SQLite format 3");
}

Result<std::unique_ptr<SqliteFile>> SqliteFile::open(const std::filesystem::path& path,
                                                     FileBytes bytes) {
  try {
    auto database = bytes.inMemory() ? openMemory(bytes.memory()) : openPath(path);
    database->exec("PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON");
    std::unique_ptr<SqliteFile> file(new SqliteFile(std::move(bytes), std::move(database)));
    const Status status = file->checkTables();
    if (!status.isOk()) return Status(status.code(), path.string() + ": " + status.message());
    return file;
  } catch (const SQLite::Exception& failure) {
    constexpr int kFiles = 3;  // the database, its journal, its folder
    if (failure.getErrorCode() == SQLITE_CANTOPEN && file_opening::areDescriptorsShort(kFiles)) {
      return Status::invalidInput(path.string() + ": " + file_opening::kNotOpened);
    }
    return Status::invalidInput(path.string() + ": is no database that can be read (" +
                                failure.what() + "); copy the bag again");
  }
}

/// Checks that both are tables, because a view may take unlimited time.
Status SqliteFile::checkTables() {
  for (const char* table : {"topics", "messages"}) {
    SQLite::Statement query(*database_,
                            "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name = ? "
                            "AND sql NOT LIKE 'CREATE VIRTUAL%'");
    query.bind(1, table);
    query.executeStep();
    if (query.getColumn(0).getInt() == 1) continue;
    return Status::invalidInput(std::string("has no table '") + table +
                                "': it is no ROS 2 bag; check the path");
  }
  return Status::ok();
}

void SqliteFile::visit(const MessageVisitor& visitor, FileDamage& damage) {
  std::int64_t rows = 0;
  try {
    visitRows(visitor, damage, rows);
  } catch (const SQLite::Exception& failure) {
    damage.problems.push_back(std::string("is damaged (") + failure.what() +
                              "); copy the bag again, or use what can be read by on_corrupt: skip");
  }
  damage.lose({}, indexedRows() - rows);
}

/// The number of messages by the index of their times, which lies in other pages than they; 0 if
/// the index is missing or damaged.
std::int64_t SqliteFile::indexedRows() {
  try {
    SQLite::Statement find(*database_,
                           "SELECT name FROM pragma_index_list('messages') WHERE partial = 0");
    if (!find.executeStep()) return 0;
    std::string name = find.getColumn(0).getString();
    for (std::size_t at = 0; (at = name.find('"', at)) != std::string::npos; at += 2) {
      name.insert(at, 1, '"');
    }
    SQLite::Statement count(*database_,
                            "SELECT count(*) FROM messages INDEXED BY \"" + name + "\"");
    return count.executeStep() ? count.getColumn(0).getInt64() : 0;
  } catch (const SQLite::Exception&) {
    return 0;
  }
}

void SqliteFile::visitRows(const MessageVisitor& visitor, FileDamage& damage, std::int64_t& found) {
  std::map<std::int64_t, Topic> topics;
  SQLite::Statement names(*database_, "SELECT id, name, type, serialization_format FROM topics");
  while (names.executeStep()) {
    topics[names.getColumn(0).getInt64()] = {names.getColumn(1).getString(),
                                             names.getColumn(2).getString(),
                                             names.getColumn(3).getString()};
  }
  // In the order of the table, because sorting here would read the images twice.
  SQLite::Statement rows(*database_, "SELECT id, topic_id, timestamp, data FROM messages");
  std::int64_t last_id = std::numeric_limits<std::int64_t>::min();
  Repeated damaged;
  Repeated wrong_clock;
  const auto tell = [&] {
    if (damaged.count() > 0) damage.problems.push_back(leftOut(damaged.text()));
    if (wrong_clock.count() > 0) damage.problems.push_back(wrongClock(wrong_clock.text()));
  };
  try {
    for (; rows.executeStep(); ++found) {
      const std::int64_t id = rows.getColumn(0).getInt64();
      const std::string what = "message " + std::to_string(id);
      const auto topic = topics.find(rows.getColumn(1).getInt64());
      const std::int64_t log_ns = rows.getColumn(2).getInt64();
      const auto message = plain(blobOf(rows.getColumn(3)));
      const bool in_order = id > last_id;  // otherwise the B-tree of the table is damaged
      last_id = std::max(last_id, id);
      if (topic == topics.end() || !message || !in_order) {
        damaged.add([&] { return what + " is damaged"; });
        damage.lose(topic == topics.end() ? Topic() : topic->second, 1);
      } else if (log_ns < 0) {
        wrong_clock.add([&] { return beforeEpoch(what, log_ns); });
        damage.lose(topic->second, 1);
      } else {
        const MessagePlace place{0, static_cast<std::uint64_t>(id), message->size()};
        visitor(topic->second, log_ns, place, *message);
      }
    }
  } catch (const SQLite::Exception&) {
    tell();
    throw;
  }
  tell();
}

Result<std::vector<std::uint8_t>> SqliteFile::read(const MessagePlace& place) {
  try {
    SQLite::Statement query(*database_, "SELECT data FROM messages WHERE id = ?");
    query.bind(1, static_cast<std::int64_t>(place.offset));
    if (!query.executeStep()) return Status::failed("has changed while it was read");
    auto message = plain(blobOf(query.getColumn(0)));
    if (!message || message->size() != place.size) {
      return Status::invalidInput(
          "is damaged, or has changed while it was read; copy the bag again");
    }
    return std::move(*message);
  } catch (const SQLite::Exception& failure) {
    return Status::invalidInput(std::string("is damaged (") + failure.what() +
                                "); copy the bag again");
  }
}

}  // namespace tolman::ros_bag
