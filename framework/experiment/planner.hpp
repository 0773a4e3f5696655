// SPDX-License-Identifier: BSD-3-Clause
// From the points of a sweep to runs whose every value is checked, with a key each: the digest of
// all that decides the results.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "config/loader.hpp"
#include "experiment/points.hpp"
#include "record/data_digest.hpp"
#include "run/checked_system.hpp"

namespace tolman::experiment {

/// Digests of what a run reads, beside its configuration.
struct Inputs {
  std::string host;                            ///< SHA-256 of the program
  std::map<std::string, std::string> plugins;  ///< by file
  std::vector<record::DataDigest> data;
};

/// One run as it will be made. Its name, its number of threads and what is recorded do not change
/// its results and are not in the key.
struct PlannedRun {
  std::string name;
  std::string key;     ///< SHA-256
  std::string folder;  ///< its name in the folder of the sweep
  std::string front;   ///< SHA-256 of all that decides the answers of source, odometry and place
  std::vector<Factor> factors;
  std::string config;  ///< config.yaml
  Inputs inputs;
  std::string needs;    ///< folder of the front end that it replays; it must be run before
  std::string replays;  ///< folder of a run with the same front end, whose answers it takes
  bool shares = false;  ///< others take its answers
  bool is_front_end = false;
};

struct PlanOptions {
  std::vector<std::string> plugin_paths;
  std::filesystem::path out;                        ///< folder of the sweep
  std::map<std::string, record::DataDigest> known;  ///< digests of earlier plans, by path
  /// The file of a configuration that is named; for shipped ones.
  std::function<std::string(const std::string&)> find_config;
  config::Environment environment;
};

struct Plan {
  std::string name;
  std::vector<PlannedRun> runs;                    ///< front ends first
  config::Problems problems;                       ///< with any, the runs are not to be used
  std::map<std::string, record::DataDigest> data;  ///< by path
};

Plan makePlan(const std::filesystem::path& file, const PlanOptions& options);

}  // namespace tolman::experiment
