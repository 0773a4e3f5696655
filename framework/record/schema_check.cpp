// SPDX-License-Identifier: BSD-3-Clause
#include "record/schema_check.hpp"

#include <algorithm>

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

void requireMotions(const Database& database) {
  Statement row(database,
                "SELECT frame FROM map_update WHERE frame NOT IN (SELECT frame FROM motion) "
                "ORDER BY frame LIMIT 1");
  if (!row.step()) return;
  throw BadRow("the motion of frame " + row.next().getString() +
               " is missing: rows of the record were removed");
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
