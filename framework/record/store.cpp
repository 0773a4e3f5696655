// SPDX-License-Identifier: BSD-3-Clause
#include "record/store.hpp"

#include <fmt/format.h>

#include <charconv>

#include "config/limits.hpp"
#include "record/rows.hpp"

namespace tolman::record {
namespace {

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
    // Setting the key, even to the same value, makes SQLite look for child rows, which scans all
    // links for each row.
    if (column.name == "id") continue;
    const std::string quoted = "\"" + column.name + "\"";
    sql.append(separator).append(quoted).append(" = excluded.").append(quoted);
    separator = ", ";
  }
  return sql;
}

void StoreWriter::insertArrays(std::int64_t frame, std::string_view source,
                               const std::vector<NamedArray>& arrays) {
  for (const NamedArray& array : arrays) {
    insert(RecordedArray{frame, std::string(source), array.name,
                         fmt::format("{}", fmt::join(array.shape, "x")),
                         Eigen::Map<const Eigen::RowVectorXf>(
                             array.values.data(), static_cast<Eigen::Index>(array.values.size()))});
  }
}

NamedArray arrayOf(const RecordedArray& row) {
  NamedArray array{row.name, shapeOf(row.shape), {row.values.begin(), row.values.end()}};
  if (!config::shapeFits(array.shape, array.values.size())) {
    throw BadRow("an array's shape does not fit its values");
  }
  return array;
}

std::vector<NamedArray> readArrays(const Database& database, std::int64_t frame,
                                   std::string_view source) {
  std::vector<NamedArray> arrays;
  const std::string condition = "WHERE \"frame\" = " + std::to_string(frame) +
                                " AND \"source\" = '" + std::string(source) + "'";
  forEachRow<RecordedArray>(database, condition,
                            [&](const RecordedArray& row) { arrays.push_back(arrayOf(row)); });
  return arrays;
}

}  // namespace tolman::record
