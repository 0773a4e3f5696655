// SPDX-License-Identifier: BSD-3-Clause
// Runs as rows of a table: their factors, all numbers of metrics.json, and finish_s and exit_code
// of run.json.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

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

}  // namespace tolman::experiment
