// SPDX-License-Identifier: BSD-3-Clause
#include "sqlite_file.hpp"

#include <SQLiteCpp/Statement.h>
#include <sqlite3.h>

#include <array>
#include <map>
#include <optional>

#include "file_bytes.hpp"

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
    for (const char* table : {"topics", "messages"}) {
      if (database->tableExists(table)) continue;
      return Status::invalidInput(path.string() + ": has no table '" + table +
                                  "': it is no ROS 2 bag; check the path");
    }
    return std::unique_ptr<SqliteFile>(new SqliteFile(std::move(bytes), std::move(database)));
  } catch (const SQLite::Exception& failure) {
    return Status::invalidInput(path.string() + ": is no database that can be read (" +
                                failure.what() + "); copy the bag again");
  }
}

void SqliteFile::visit(const MessageVisitor& visitor, const DamageVisitor& damage) {
  try {
    std::map<std::int64_t, Topic> topics;
    SQLite::Statement names(*database_, "SELECT id, name, type, serialization_format FROM topics");
    while (names.executeStep()) {
      topics[names.getColumn(0).getInt64()] = {names.getColumn(1).getString(),
                                               names.getColumn(2).getString(),
                                               names.getColumn(3).getString()};
    }
    // In the order of the table, because sorting here would read the images twice.
    SQLite::Statement rows(*database_, "SELECT id, topic_id, timestamp, data FROM messages");
    while (rows.executeStep()) {
      const std::int64_t id = rows.getColumn(0).getInt64();
      const auto topic = topics.find(rows.getColumn(1).getInt64());
      const auto message = plain(blobOf(rows.getColumn(3)));
      if (topic == topics.end() || !message) {
        damage("has a damaged message of the id " + std::to_string(id));
        continue;
      }
      const MessagePlace place{0, static_cast<std::uint64_t>(id), message->size()};
      visitor(topic->second, rows.getColumn(2).getInt64(), place, *message);
    }
  } catch (const SQLite::Exception& failure) {
    damage(std::string("is damaged (") + failure.what() + ")");
  }
}

Result<std::vector<std::uint8_t>> SqliteFile::read(const MessagePlace& place) {
  try {
    SQLite::Statement query(*database_, "SELECT data FROM messages WHERE id = ?");
    query.bind(1, static_cast<std::int64_t>(place.offset));
    if (!query.executeStep()) return Status::failed("has changed while it was read");
    auto message = plain(blobOf(query.getColumn(0)));
    if (!message || message->size() != place.size) {
      return Status::invalidInput("is damaged");
    }
    return std::move(*message);
  } catch (const SQLite::Exception& failure) {
    return Status::invalidInput(std::string("is damaged (") + failure.what() + ")");
  }
}

}  // namespace tolman::ros_bag
