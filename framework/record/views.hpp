// SPDX-License-Identifier: BSD-3-Clause
// Views of run.sqlite for queries by hand: poses in the plane with headings as numbers, and no
// column whose name is a word of SQL. The tables stay as they are, so records without views are
// read as well.
#pragma once

#include <string>
#include <vector>

namespace tolman::record {

struct View {
  std::string name;
  std::string doc;
  std::string select;
};

std::vector<View> views();

std::string createSql(const View& view);

}  // namespace tolman::record
