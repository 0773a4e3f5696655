// SPDX-License-Identifier: BSD-3-Clause
#include "record/store.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace tolman::record {
namespace {

std::string shapeText(const std::vector<int>& shape) {
  std::string text;
  for (const int size : shape) {
    if (!text.empty()) text += 'x';
    text += std::to_string(size);
  }
  return text;
}

std::vector<int> shapeOf(const std::string& text) {
  std::vector<int> shape;
  const char* next = text.data();
  const char* const end = next + text.size();
  while (next < end) {
    int size = 0;
    const auto [after, error] = std::from_chars(next, end, size);
    if (error != std::errc() || (after < end && *after != 'x')) {
      throw BadRow("'" + text.substr(0, 24) + "' is no shape of an array");
    }
    shape.push_back(size);
    next = after < end ? after + 1 : end;
  }
  return shape;
}

}  // namespace

std::string StoreWriter::upsertSql(const std::string& table, const Columns& columns) {
  std::string sql = insertSql(table, columns) + " ON CONFLICT (\"id\") DO UPDATE SET ";
  const char* separator = "";
  for (const Column& column : columns) {
    // Setting the key, even to itself, makes SQLite look for children: a scan of all links a row.
    if (column.name == "id") continue;
    const std::string quoted = "\"" + column.name + "\"";
    sql.append(separator).append(quoted).append(" = excluded.").append(quoted);
    separator = ", ";
  }
  return sql;
}

Statement& StoreWriter::insertion(std::string_view table) {
  return statement(table, [&] {
    const std::vector<Table> tables = schema();
    const auto found = std::ranges::find(tables, table, &Table::name);
    return insertSql(found->name, found->columns);
  });
}

void StoreWriter::insertArrays(std::int64_t frame, std::string_view source,
                               const std::vector<NamedArray>& arrays) {
  Statement& row = insertion("array");
  for (const NamedArray& array : arrays) {
    row.bind(frame);
    row.bind(source);
    row.bind(std::string_view(array.name));
    row.bind(std::string_view(shapeText(array.shape)));
    row.bind(std::as_bytes(std::span(array.values)));
    row.run();
  }
}

std::vector<NamedArray> readArrays(const Database& database, std::int64_t frame,
                                   std::string_view source) {
  Statement rows(database,
                 "SELECT \"name\", \"shape\", \"values\" FROM \"array\""
                 " WHERE \"frame\" = ? AND \"source\" = ? ORDER BY rowid");
  rows.bind(frame);
  rows.bind(source);
  std::vector<NamedArray> arrays;
  while (rows.step()) {
    NamedArray& array = arrays.emplace_back();
    array.name = rows.text();
    array.shape = shapeOf(rows.text());
    const std::vector<std::byte> bytes = rows.blob();
    if (bytes.size() % sizeof(float) != 0) throw BadRow("an array has a broken number of bytes");
    std::size_t size = 1;
    for (const int side : array.shape) {
      if (side < 0 || (side > 0 && size > bytes.size() / static_cast<std::size_t>(side))) {
        throw BadRow("an array's shape does not fit its values");
      }
      size *= static_cast<std::size_t>(side);
    }
    if (size != bytes.size() / sizeof(float)) {
      throw BadRow("an array's shape does not fit its values");
    }
    array.values.resize(size);
    if (!bytes.empty()) std::memcpy(array.values.data(), bytes.data(), bytes.size());
  }
  return arrays;
}

}  // namespace tolman::record
