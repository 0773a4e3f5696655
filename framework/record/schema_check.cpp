// SPDX-License-Identifier: BSD-3-Clause
#include "record/schema_check.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "record/schema.hpp"

namespace tolman::record {

void requireOwnTables(const Database& database) {
  const std::vector<Table> own = schema();
  Statement rows(database,
                 "SELECT type, name FROM sqlite_master WHERE type IN ('trigger', 'view')");
  while (rows.step()) {
    const std::string type = rows.next().getString();
    const std::string name = rows.next().getString();
    if (type == "trigger") {
      throw BadRow("has a trigger '" + name.substr(0, 40) + "', which no run writes; remove it");
    }
    if (std::ranges::find(own, name, &Table::name) != own.end()) {
      throw BadRow("'" + name + "' is a view, and not the table of a run");
    }
  }
}

void requireRowsOfFrames(const Database& database) {
  const auto frameOf = [&](const std::string& query) {
    Statement row(database, query + " ORDER BY frame LIMIT 1");
    return row.step() ? row.next().getString() : std::string();
  };
  const auto requireAll = [&](const std::string& table, const std::string& other) {
    const std::string frame = frameOf("SELECT frame FROM " + other +
                                      " WHERE frame NOT IN (SELECT frame FROM " + table + ")");
    if (frame.empty()) return;
    throw BadRow("the " + table + " of frame " + frame +
                 " is missing: rows of the record were removed");
  };
  std::vector<std::string> tables = {"frame", "motion", "place", "decision", "map_update"};
  std::erase_if(tables, [&](const std::string& table) {
    return frameOf("SELECT frame FROM " + table).empty();
  });
  for (std::size_t i = 1; i < tables.size(); ++i) {
    requireAll(tables[i], tables[0]);
    requireAll(tables[0], tables[i]);
  }
  const std::string frame = frameOf(
      "SELECT frame.frame FROM frame JOIN motion USING (frame) WHERE frame.stamp_ns <> "
      "motion.stamp_ns");
  if (!frame.empty()) throw BadRow("the stamps of frame " + frame + " and of its motion differ");
}

std::string rowCounts(const Database& database) {
  std::string text;
  for (const char* table : {"session", "frame", "motion", "motion_revision", "place", "decision",
                            "map_update", "final_pose", "experience", "link"}) {
    Statement row(database, std::string("SELECT count(*) FROM \"") + table + "\"");
    row.step();
    text += (text.empty() ? "" : " ") + std::string(table) + "=" +
            std::to_string(row.next().getInt64());
  }
  return text;
}

}  // namespace tolman::record
