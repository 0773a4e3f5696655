// SPDX-License-Identifier: BSD-3-Clause
// Which runs may be averaged, and notes for the reader of a table about its runs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiment/run_table.hpp"

namespace tolman::experiment {

/// Coverages (shares of the frames) that differ by less are the same.
inline constexpr double kSameCoverage = 0.02;

using RunPointers = std::vector<const RunRow*>;
RunPointers pointersTo(const std::vector<RunRow>& rows);

/// InvalidInput for runs with different alignments, for runs that tracked nothing, for runs of one
/// sequence with different true poses or coverages, and where one of `metrics` is a drift that was
/// measured over segments of different lengths. With `mixed_coverage` coverages may differ.
Status refuseMixtures(const RunPointers& runs, const std::vector<std::string>& metrics,
                      bool mixed_coverage);

/// Keeps one run of each setting (same factors, seed and sequence). Returns a note about the number
/// of removed runs, which have the same results; empty if there are none. InvalidInput for two runs
/// of one setting with different results: they must not be in one statistic.
Result<std::string> mergeRepeats(std::vector<RunRow>& rows);

/// The failure that these two runs of one setting have different results.
Status oneSetting(const RunRow& a, const RunRow& b);

/// The labels of these factors, joined by ", ": the name of a row of a table.
std::string levelName(const RunRow& row, const std::vector<std::string>& by);

/// Factors besides seed and sequence whose levels never changed the results (byte for byte) in runs
/// that are equal in all other factors.
std::vector<std::string> factorsWithoutEffect(const std::vector<RunRow>& rows);

/// A warning about the signed rank test and the bootstrap for few sequences, or few seeds of one
/// sequence: the smallest possible p is 2 / 2^n. Empty if that is below 0.05.
std::string fewSamplesNote(std::size_t sequences, std::size_t seeds);

/// A warning about sequences that have one true path, such as copies of one drive; empty if all
/// differ. Test and bootstrap take them for independent.
std::string sameTruthNote(const std::vector<RunRow>& rows);

/// Notes on runs that lost tracking, and on runs that cover different shares of their truth.
std::vector<std::string> trackingNotes(const std::vector<RunRow>& rows);

}  // namespace tolman::experiment
