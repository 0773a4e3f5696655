// SPDX-License-Identifier: BSD-3-Clause
// Names of the rows of a table, which join the labels of several factors.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiment/run_table.hpp"

namespace tolman::experiment {

class LevelNames {
 public:
  /// The labels of these factors, joined by ", ".
  static std::string nameOf(const RunRow& row, const std::vector<std::string>& by);

  /// InvalidInput if a run that was added before has the same name, but other labels, as "1, 2" and
  /// "3" have with "1" and "2, 3": both would be in one row. The rows must outlive this.
  Status add(const RunRow& row, const std::vector<std::string>& by);

 private:
  std::map<std::string, const RunRow*> first_;
};

}  // namespace tolman::experiment
