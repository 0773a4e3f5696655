// SPDX-License-Identifier: BSD-3-Clause
// A bag in a SQLite database, .db3, as rosbag2 writes it: tables `topics` and `messages`. Messages
// may be compressed one by one (Zstandard).
#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <memory>

#include "bag.hpp"
#include "file_bytes.hpp"

namespace tolman::ros_bag {

class SqliteFile final : public BagFile {
 public:
  /// Opens the database read-only. `bytes`: the bytes of the file; they are kept if the file was
  /// compressed as a whole.
  static Result<std::unique_ptr<SqliteFile>> open(const std::filesystem::path& path,
                                                  FileBytes bytes);
  /// Whether the file begins as a SQLite database does.
  static bool isSqlite(FileBytes& file);

  void visit(const MessageVisitor& visitor, const DamageVisitor& damage) override;
  Result<std::vector<std::uint8_t>> read(const MessagePlace& place) override;

 private:
  SqliteFile(FileBytes bytes, std::unique_ptr<SQLite::Database> database)
      : bytes_(std::move(bytes)), database_(std::move(database)) {}

  FileBytes bytes_;
  std::unique_ptr<SQLite::Database> database_;
};

}  // namespace tolman::ros_bag
