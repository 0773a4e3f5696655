// SPDX-License-Identifier: BSD-3-Clause
#include "base/record_rows.hpp"

#include <charconv>
#include <nlohmann/json.hpp>

namespace tolman::record {

using Json = nlohmann::ordered_json;

std::string columnList(const Columns& columns) {
  std::string sql;
  for (const Column& column : columns) sql += (sql.empty() ? "\"" : ", \"") + column.name + "\"";
  return sql;
}

std::string selectSql(const std::string& table, const Columns& columns,
                      const std::string& condition) {
  return "SELECT " + columnList(columns) + " FROM \"" + table + "\" " + condition +
         " ORDER BY rowid";
}

std::string entryOf(const Database& database, const std::string& key) {
  Statement row(database, "SELECT \"value\" FROM \"run\" WHERE \"key\" = ?");
  row.bindNext(key);
  return row.step() ? row.next().getString() : "";
}

NamedArray arrayOf(const RecordedArray& row) {
  NamedArray array{row.name, {}, {row.values.begin(), row.values.end()}};
  std::size_t size = 1;
  const char* const end = row.shape.data() + row.shape.size();
  for (const char* next = row.shape.data(); next < end; ++next) {  // over the x as well
    std::size_t side = 0;
    const auto [after, error] = std::from_chars(next, end, side);
    if (error != std::errc()) break;
    array.shape.push_back(static_cast<int>(side));
    size *= side;
    next = after;
  }
  if (size == array.values.size()) return array;
  throw std::domain_error("the shape " + row.shape + " of array '" + row.name +
                          "' does not fit its values");
}

RecordedArrayInfo toRow(const ArrayInfo& info) {
  Json axes = Json::array();
  for (const ArrayAxis& axis : info.axes) {
    Json& json = axes.emplace_back();
    visitFields(axis, [&](const Field& field, const auto& value) {
      json[std::string(field.name)] = value;
    });
  }
  const auto replace = Json::error_handler_t::replace;
  return {info.name, info.kind,       info.unit,
          info.doc,  info.population, axes.dump(-1, ' ', false, replace)};
}

ArrayInfo fromRow(const RecordedArrayInfo& row) {
  ArrayInfo info{row.name, row.kind, row.unit, row.doc, row.population, {}};
  try {
    for (const Json& json : Json::parse(row.axes)) {
      ArrayAxis& axis = info.axes.emplace_back();
      visitFields(axis, [&](const Field& field, auto& value) {
        json.at(std::string(field.name)).get_to(value);
      });
    }
  } catch (const Json::exception& error) {
    throw std::domain_error("the axes of array '" + row.name + "' are damaged: " + error.what());
  }
  return info;
}

}  // namespace tolman::record
