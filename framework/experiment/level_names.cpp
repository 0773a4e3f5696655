// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/level_names.hpp"

namespace tolman::experiment {

std::string LevelNames::nameOf(const RunRow& row, const std::vector<std::string>& by) {
  std::string name;
  for (const std::string& factor : by) {
    name += (&factor == &by.front() ? "" : ", ") + row.label(factor);
  }
  return name;
}

Status LevelNames::add(const RunRow& row, const std::vector<std::string>& by) {
  const std::string name = nameOf(row, by);
  const RunRow& same = *first_.try_emplace(name, &row).first->second;
  for (const std::string& factor : by) {
    if (same.label(factor) == row.label(factor)) continue;
    return Status::invalidInput("'" + same.name + "' and '" + row.name + "' differ in " + factor +
                                ", but both would be in the row '" + name +
                                "'; rename a label, or compare by one factor at a time");
  }
  return Status::ok();
}

}  // namespace tolman::experiment
