// SPDX-License-Identifier: BSD-3-Clause
#include "record/rows.hpp"

#include <nlohmann/json.hpp>

#include "base/bounded_json.hpp"
#include "record/sqlite.hpp"

namespace tolman::record {

using Json = nlohmann::ordered_json;

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
    for (const Json& json : bounded_json::parse<Json>(row.axes)) {
      ArrayAxis& axis = info.axes.emplace_back();
      visitFields(axis, [&](const Field& field, auto& value) {
        json.at(std::string(field.name)).get_to(value);
      });
    }
  } catch (const Json::exception& error) {
    throw BadRow("the axes of array '" + row.name + "' are damaged: " + error.what());
  }
  return info;
}

}  // namespace tolman::record
