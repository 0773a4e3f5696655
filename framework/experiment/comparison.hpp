// SPDX-License-Identifier: BSD-3-Clause
// Compares runs: the levels of factors over all sequences and seeds, paired with a baseline; or
// metrics as cells of a table with the levels of one factor as columns.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiment/run_table.hpp"
#include "experiment/statistics.hpp"
#include "experiment/tables.hpp"

namespace tolman::experiment {

struct ComparisonOptions {
  std::string metric = "map.ate.rmse_m";  ///< a key of metrics.json, or its last parts
  /// Factors; empty: all that vary besides sequence and seed. But if runs outside a sweep differ in
  /// more than one key, each run is a level of its own.
  std::vector<std::string> by;
  std::vector<std::pair<std::string, std::string>> only;  ///< see hasLabels()
  std::string baseline;                                   ///< level; empty: the first
  bool mixed_coverage = false;                            ///< average runs whose coverage differs
  std::uint64_t seed = 1;                                 ///< of the bootstrap
};

/// Differences to the baseline, between runs that are equal in all other factors.
struct PairedDifference {
  std::size_t pairs = 0;
  double mean = 0;
  /// None if a sequence has fewer than kMinSeeds seeds with different results, or pairs of fewer
  /// seeds, or if there are pairs of only one of several sequences.
  std::optional<Interval> interval;
  std::optional<SignedRank> test;  ///< over the means of the sequences; for one sequence over seeds
};

struct Level {
  std::string label;
  std::vector<double> values{};                      ///< of all runs
  std::vector<std::filesystem::path> directories{};  ///< of the same runs
  Summary summary{};
  std::optional<Interval> interval{};            ///< of the mean, as in PairedDifference
  std::optional<PairedDifference> difference{};  ///< to the baseline; none for the baseline
};

struct Comparison {
  std::string metric;
  std::vector<std::string> by;
  std::string baseline;
  std::vector<Level> levels;
  std::string alignment;           ///< of all runs
  std::size_t truths = 0;          ///< different true paths
  std::vector<std::string> notes;  ///< warnings and limits, for the reader
};

inline constexpr std::size_t kMinSeeds = 3;

/// InvalidParameter for an unknown metric or factor; InvalidInput for runs that must not be
/// averaged (averaging.hpp).
Result<Comparison> compareRuns(const std::vector<RunRow>& rows, const ComparisonOptions& options);

Table tableOf(const Comparison& comparison);

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
/// averaged.
Result<Table> pivotOf(const std::vector<RunRow>& rows, const PivotOptions& options);

}  // namespace tolman::experiment
