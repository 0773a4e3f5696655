// SPDX-License-Identifier: BSD-3-Clause
// Tables of metrics with the levels of one factor as columns, such as one column per sequence, or
// with a column for each of several metrics.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiment/run_table.hpp"
#include "experiment/tables.hpp"

namespace tolman::experiment {

struct PivotOptions {
  std::vector<std::string> by;  ///< factors of the rows; empty: all but the columns' and seed
  std::string columns;          ///< factor of the columns; empty: those of `values`
  std::vector<std::pair<std::string, std::string>> values;  ///< heading and cell of each column
  std::vector<std::string> over;  ///< factors besides the seed over which a cell takes the mean
  /// Text of a cell, with metrics and their formats in braces: "{map.ate.rmse_m:.2f} m".
  std::string cell;
  /// Rows above the others, as label and cell; they show the runs of the first row.
  std::vector<std::pair<std::string, std::string>> heads;
  std::vector<std::pair<std::string, std::string>> only;  ///< see hasLabels()
  bool mixed_coverage = false;                            ///< as in ComparisonOptions
};

/// A cell of several runs has the means of their metrics. InvalidParameter for unknown names and
/// formats; InvalidInput where the runs of one cell differ in more than the seed, or must not be
/// averaged (mixtures.hpp).
Result<TextTable> pivotOf(const std::vector<RunRow>& rows, const PivotOptions& options);

}  // namespace tolman::experiment
