// SPDX-License-Identifier: BSD-3-Clause
// Runs as rows: factors, and all numbers of metrics.json, and finish_s of run.json.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "experiment/sweep_file.hpp"
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
  bool is_alone = false;  ///< of no sweep; its name is one of distinctNames()

  /// Empty where the run has no such factor.
  std::string label(const std::string& factor) const;
};

/// Of sweeps all runs of the last plan that are done, without front ends, of others the run, and of
/// files .csv the runs that csvOf() wrote. The factors of runs outside a sweep are the keys in
/// which their configurations differ.
Result<std::vector<RunRow>> readRunRows(const std::vector<std::filesystem::path>& folders);

/// How many runs of a sweep failed or are not done; empty where all are, and for what is no sweep.
std::string unfinishedText(const std::filesystem::path& sweep);

/// One line a run: name, factors, alignment, digests of truth and results, metrics: all but
/// times, or those that are wanted.
std::string csvOf(const std::vector<RunRow>& rows, const std::vector<std::string>& wanted = {});

}  // namespace tolman::experiment
