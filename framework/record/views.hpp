// SPDX-License-Identifier: BSD-3-Clause
// Views of run.sqlite for queries by hand: poses in the plane with headings as numbers, and no
// column names that are words of SQL. The program reads only the tables, so it also reads records
// without views.
#pragma once

#include <string>
#include <vector>

namespace tolman::record {

struct SqlView {
  std::string name;
  std::string doc;
  std::string select;
};

std::vector<SqlView> views();

std::string createSql(const SqlView& view);

}  // namespace tolman::record
