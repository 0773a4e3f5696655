// SPDX-License-Identifier: BSD-3-Clause
// Detects runs whose errors must not be averaged.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "experiment/run_table.hpp"

namespace tolman::experiment {

/// Coverages (shares of the frames) that differ by less are the same.
inline constexpr double kSameCoverage = 0.02;

using RunPointers = std::vector<const RunRow*>;
RunPointers pointersTo(const std::vector<RunRow>& rows);

/// InvalidInput for runs with different alignments, for runs that tracked nothing, and for runs of
/// one sequence with different true poses or coverages. With `mixed_coverage` coverages may differ.
Status refuseMixtures(const RunPointers& runs, bool mixed_coverage);

/// InvalidInput where `metric` is a drift and was measured over segments of different lengths.
Status refuseMixedLengths(const RunPointers& runs, const std::string& metric);

/// InvalidInput where two sequences have the same results byte for byte in all their runs: copies
/// of one drive would count as independent.
Status refuseCopies(const RunPointers& runs);

// Runs that were given twice, such as those of two copies of a sweep.

/// Keeps one run of each setting (same factors, seed and sequence). Returns a note about the number
/// of removed runs, which have the same results, and about those of them with other figures in
/// spite of the same digest; empty if there are none. InvalidInput for two runs of one setting with
/// different results: they must not be in one statistic.
Result<std::string> mergeRepeats(std::vector<RunRow>& rows);

/// The failure that these two runs of one setting have different results.
Status oneSetting(const RunRow& a, const RunRow& b);

// Names of the rows of a table, which join the labels of several factors.

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

// Notes of a comparison about its runs: factors without effect, and too few samples.

/// Factors besides seed and sequence whose levels never changed the results (byte for byte) in runs
/// that are equal in all other factors.
std::vector<std::string> factorsWithoutEffect(const std::vector<RunRow>& rows);

/// A warning about the signed rank test and the bootstrap for few sequences, or few seeds of one
/// sequence: the smallest possible p is 2 / 2^n. Empty if that is below 0.05.
std::string fewSamplesNote(std::size_t sequences, std::size_t seeds);

/// A warning about sequences that have one true path, such as one drive with two settings; empty if
/// all differ. Test and bootstrap take them for independent.
std::string sameTruthNote(const std::vector<RunRow>& rows);

/// A note on levels whose mean and interval weigh the runs differently.
std::string unevenRunsNote(const std::vector<std::string>& levels);

/// Notes on runs that lost tracking, and on runs that cover different shares of their truth.
std::vector<std::string> trackingNotes(const std::vector<RunRow>& rows);

}  // namespace tolman::experiment
