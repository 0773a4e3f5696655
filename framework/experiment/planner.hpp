// SPDX-License-Identifier: BSD-3-Clause
// Turns the points of a sweep into runs with checked values. Each has a key: the digest of
// everything that determines its results.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "config/loader.hpp"
#include "engine/checked_system.hpp"
#include "experiment/sweep_file.hpp"
#include "record/data_digest.hpp"

namespace tolman::experiment {

/// Digests of the inputs of a run besides its configuration.
struct Inputs {
  std::string host;                            ///< SHA-256 of the program
  std::map<std::string, std::string> plugins;  ///< by file
  std::vector<record::DataDigest> data;
};

/// One planned run. Its name, its number of threads, and `record.replay`, `record.report` and
/// `record.state_every` do not change its results and are not in the key.
struct PlannedRun {
  std::string name;
  std::string key;               ///< SHA-256
  std::string folder;            ///< its name in the folder of the sweep
  std::string front_end_sha256;  ///< of all that determines answers of source, odometry and place
  std::vector<Factor> factors;
  std::string config;         ///< config.yaml
  std::string config_sha256;  ///< of config.yaml when it was frozen; known of frozen runs
  Inputs inputs;
  std::string front_end_folder;  ///< folder of the front end that it replays, which must run before
  std::string answers_folder;  ///< folder of a run with the same front end, whose answers it takes
  bool keeps_answers = false;  ///< for other runs, which replay them
  bool is_front_end = false;
};

struct PlanOptions {
  std::vector<std::string> plugin_paths;
  std::filesystem::path out;                        ///< folder of the sweep
  std::map<std::string, record::DataDigest> known;  ///< digests of earlier plans, by path
  /// Finds the file of a shipped configuration by its name.
  std::function<std::string(const std::string&)> find_config;
  config::FindShipped find_shipped;  ///< for `extends`
  config::Environment environment;
};

struct Plan {
  std::string name;
  std::vector<PlannedRun> runs;                    ///< front ends first
  config::Problems problems;                       ///< if there are any, do not use the runs
  std::map<std::string, record::DataDigest> data;  ///< by path
  std::set<std::string> missing;                   ///< paths of sources that do not exist
};

Plan makePlan(const std::filesystem::path& file, const PlanOptions& options);

}  // namespace tolman::experiment
