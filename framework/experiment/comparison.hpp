// SPDX-License-Identifier: BSD-3-Clause
// Runs as rows of a table: their factors, all numbers of metrics.json, and finish_s and exit_code
// of run.json. Comparisons of runs: the levels of factors over all sequences and seeds, paired with
// a baseline; or metrics as cells of a table with the levels of one factor as columns. Which runs
// may be averaged, and what the reader of a table must know of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/association.hpp"
#include "evaluation/errors.hpp"
#include "experiment/sweep_file.hpp"
#include "experiment/tables.hpp"
#include "tolman/status.hpp"

namespace tolman::experiment {

struct RunRow {
  std::string name;
  std::filesystem::path directory;  ///< of the run
  std::vector<Factor> factors;
  std::map<std::string, double> metrics;  ///< "map.ate.rmse_m"
  std::string alignment;
  std::string truth;      ///< digest of the true poses of the frames; empty without truth
  std::string results;    ///< digest of results.sha256
  bool is_alone = false;  ///< not a run of a sweep; its name is one of distinctNames()

  /// The label of a factor; empty if the run has no such factor.
  std::string label(const std::string& factor) const;
  /// All labels but those of these factors, as one text: equal in runs that differ in no other
  /// factor, whatever the order of their factors.
  std::string labelsWithout(const std::vector<std::string>& left_out) const;
};

/// Reads runs: of a sweep all runs of the last plan that are done, without front ends; of a run
/// directory the run; of a .csv file the runs of tableOf(). A folder that is given twice counts
/// once. The factors of runs outside a sweep are the keys in which their configurations differ.
Result<std::vector<RunRow>> readRunRows(const std::vector<std::filesystem::path>& folders);

/// Whether a metric is a time, which differs from run to run of the same configuration.
bool isTime(const std::string& metric);

/// How many runs of a sweep failed or are not done; empty if all are done or it is not a sweep.
std::string unfinishedText(const std::filesystem::path& sweep);

/// For programs, one row per run: name, factors, alignment, digests of truth and results, and the
/// metrics `wanted`; by default all except times.
Table tableOf(const std::vector<RunRow>& rows, const std::vector<std::string>& wanted = {});

/// The factors of all rows, in the order of their first occurrence.
std::vector<std::string> factorNames(const std::vector<RunRow>& rows);

// Statistics of repeated runs.

struct Interval {
  double low = 0;
  double high = 0;
};

/// The 95 % percentile interval of the mean by the bootstrap (Efron 1979), from 10,000 resamples.
/// With several groups (sequences) a resample draws groups with replacement, then values (seeds)
/// within each; its mean is the mean of the group means. No group is empty.
Interval bootstrapMean(const std::vector<std::vector<double>>& groups, std::uint64_t seed);

struct SignedRank {
  std::size_t n = 0;  ///< differences that are not zero
  double p = 1;  ///< two-sided, exact (over all signs of the ranks); ties share their mean rank
  double effect = 0;  ///< matched-pairs rank-biserial correlation, -1 to 1 (Kerby 2014)
};
/// Wilcoxon's signed rank test of at most 1000 differences against zero; zeros are left out (1945).
SignedRank signedRank(const std::vector<double>& differences);

/// Factors and labels: a run has, for each factor, one of its labels here.
using Labels = std::vector<std::pair<std::string, std::string>>;
bool hasLabels(const RunRow& row, const Labels& only);

struct ComparisonOptions {
  std::string metric = "map.ate.rmse_m";  ///< a key of metrics.json, or its last parts
  /// Factors; empty: all that vary besides sequence and seed. But if runs outside a sweep differ in
  /// more than one key, each run is a level of its own.
  std::vector<std::string> by;
  Labels only;
  std::string baseline;    ///< level; empty: the first
  std::uint64_t seed = 1;  ///< of the bootstrap
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
  evaluation::Statistics summary{};
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

/// "75, small" is 75 and "small"; none where the first label is no number.
std::optional<std::pair<double, std::string>> leadingNumber(const std::string& label);

/// InvalidParameter for unknown names; InvalidInput for runs that must not be averaged.
Result<Comparison> compareRuns(const std::vector<RunRow>& rows, const ComparisonOptions& options);

Table tableOf(const Comparison& comparison);

/// SVG, as wide as a column of a paper (88.9 mm): the mean over the first factor with its interval
/// as a band, a line for each of the rest; where its labels are no numbers, a column of dots for
/// each level.
std::string levelsFigure(const Comparison& comparison);
/// The true path, and the map of the median run of each level, from the records. InvalidParameter
/// for several true paths; InvalidInput for records that cannot be read.
Result<std::string> mapsFigure(const Comparison& comparison);

// Runs of one recording with different modules: which is best, and which differences it can decide.

/// The map of a run, transformed into the coordinates of its truth. Throws (base/must.hpp).
evaluation::Matches alignedMap(const std::filesystem::path& run, const std::string& alignment);

struct Ranked {
  const RunRow* run = nullptr;
  double rmse_m = 0;     ///< position error of the map after alignment
  Interval interval{};   ///< 95 %, of rmse_m
  bool as_good = false;  ///< the first, or no worse as far as this recording can decide
};

/// The runs with an error, best first. Intervals are bootstrapped over equal parts of the true
/// path, because errors of neighbouring frames are alike. A run is as good as the best if the
/// interval of their difference in squared error, part by part, includes zero. `rows` must outlive
/// the result. InvalidInput for records that cannot be read.
Result<std::vector<Ranked>> rankedRuns(const std::vector<RunRow>& rows);

/// The ranked runs, then those without an error: factors, error, loop links.
Table tableOf(const std::vector<Ranked>& ranked, const std::vector<RunRow>& rows);

struct PivotOptions {
  std::vector<std::string> by;    ///< factors of the rows; empty: all but the columns' and seed
  std::string columns;            ///< factor of the columns; empty: those of `values`
  Labels values;                  ///< heading and cell of each column
  std::vector<std::string> over;  ///< factors besides the seed over which a cell takes the mean
  /// Text of a cell, with metrics and their formats in braces: "{map.ate.rmse_m:.2f} m".
  std::string cell;
  /// Rows above the others, as label and cell; they show the runs of the first row.
  Labels heads;
  Labels only;
};

/// A cell of several runs has the means of their metrics. InvalidParameter for unknown names and
/// formats; InvalidInput for cells of different runs, or of runs that must not be averaged.
Result<Table> pivotOf(const std::vector<RunRow>& rows, const PivotOptions& options);

// What comparisons and pivots share. Refusals are thrown (base/must.hpp).

/// The rows with the labels of `only`, whose factors may be given by their ends.
std::vector<RunRow> selectRuns(std::vector<RunRow> rows, const Labels& only);
/// The full names of these factors of the rows.
std::vector<std::string> fullFactors(const std::vector<RunRow>& rows,
                                     const std::vector<std::string>& wanted);

using RunPointers = std::vector<const RunRow*>;

/// Refuses runs with different alignments, runs that tracked nothing, runs of one sequence with
/// different true poses or coverages (by more than 2 %), and where one of `metrics` is a drift over
/// segments of different lengths.
void refuseMixtures(const RunPointers& runs, const std::vector<std::string>& metrics);

/// Keeps one run of each setting (same factors, seed and sequence). Returns a note about the number
/// of removed runs, which have the same results; empty if there are none.
std::string mergeRepeats(std::vector<RunRow>& rows);
/// Two runs of one setting with different results must not be in one statistic.
[[noreturn]] void refuseSetting(const RunRow& a, const RunRow& b);

/// The labels of these factors, joined by ", ": the name of a row of a table.
std::string levelName(const RunRow& row, const std::vector<std::string>& by);

/// Notes on runs that lost tracking, and on runs that cover different shares of their truth.
std::vector<std::string> trackingNotes(const std::vector<RunRow>& rows);

}  // namespace tolman::experiment
