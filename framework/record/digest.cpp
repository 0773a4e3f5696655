// SPDX-License-Identifier: BSD-3-Clause
#include "record/digest.hpp"

#include <array>
#include <fstream>

#include "record/atomic_file.hpp"
#include "record/export.hpp"
#include "record/run_reader.hpp"
#include "record/sha256.hpp"

namespace tolman::record {
namespace {

/// Each value with its size before it, so that different tables give different digests. Reals are
/// added as their eight bytes, integers as decimal text.
void addTable(const Database& database, const Table& table, Sha256& sha) {
  sha.add(table.name + "\n");
  Statement rows(database, "SELECT " + columnList(table.columns) + " FROM \"" + table.name +
                               "\" ORDER BY rowid");
  while (rows.step()) {
    for (const Column& column : table.columns) {
      const SQLite::Column value = rows.next();
      if (value.isNull()) {
        sha.add("null ");
      } else if (column.type == "REAL") {
        const double real = value.getDouble();
        sha.add(std::as_bytes(std::span(&real, 1)));
      } else {
        const std::string bytes = value.getString();
        sha.add(std::to_string(bytes.size()) + " " + bytes);
      }
    }
  }
}

}  // namespace

Result<std::string> fileDigest(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Sha256 sha;
  std::array<char, 65536> buffer{};
  while (stream.read(buffer.data(), buffer.size()) || stream.gcount() > 0) {
    sha.add(std::string_view(buffer.data(), static_cast<std::size_t>(stream.gcount())));
  }
  if (!stream.eof()) return Status::invalidInput(file.string() + ": cannot be read");
  return sha.digest();
}

Result<std::string> databaseDigest(const std::filesystem::path& run_directory) {
  const auto reader = RunReader::open(run_directory);
  if (!reader.isOk()) return reader.status();
  return answered(run_directory.string(), [&] {
    Sha256 sha;
    for (const Table& table : schema()) {
      if (table.deterministic) addTable(reader.value()->database(), table, sha);
    }
    return sha.digest();
  });
}

Status writeResultsDigest(const std::filesystem::path& run_directory) {
  std::string text;
  for (const std::string_view file : kExportedFiles) {
    if (!std::filesystem::exists(run_directory / file)) continue;
    const Result<std::string> digest = fileDigest(run_directory / file);
    if (!digest.isOk()) return digest.status();
    text += digest.value() + "  " + std::string(file) + "\n";
  }
  return writeAtomically(run_directory / "results.sha256", text);
}

}  // namespace tolman::record
