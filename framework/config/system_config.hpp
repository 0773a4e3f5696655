// SPDX-License-Identifier: BSD-3-Clause
// A system as configured: the host's settings and the stages in the order of the flow.
#pragma once

#include <string>
#include <vector>

#include "config/check.hpp"
#include "config/loader.hpp"
#include "config/settings.hpp"
#include "tolman/roles.hpp"

namespace tolman::config {

/// One stage. Its own parameters wait, unchecked, until the plugin's schema is known.
struct StageConfig {
  Role role = Role::Source;
  std::string path;      ///< "odometry", "observers.0"
  std::string plugin;    ///< id
  std::string instance;  ///< unique in the system: `name`, else the role, for observers the plugin
  FailurePolicy on_failure = FailurePolicy::Stop;
  Isolation isolation = Isolation::None;
  Node given;  ///< the map as configured

  /// Where the plugin was named, for the message that there is no such plugin.
  Origin pluginOrigin() const;
};

/// One group of the host's own keys, as checked.
struct Section {
  std::string key;  ///< "" for the keys at the top
  ParameterValues values;
  Node given;  ///< Null when absent
};

struct SystemConfig {
  GeneralSettings general;
  PipelineSettings pipeline;
  EvaluationSettings evaluation;
  RecordSettings record;
  IsolationSettings isolation;
  std::vector<Section> sections;    ///< the same values, with their origins
  std::vector<StageConfig> stages;  ///< source, odometry, place, cells, map, observers
  Places places;
};

/// First step: everything but the plugins' own parameters. Fills in defaults where there are
/// problems; do not run with any.
SystemConfig parse(const Loaded& loaded, Problems& problems);

/// Second step, for each stage: its plugin's parameters, complete.
ParameterValues check(const StageConfig& stage, const Schema& schema, const Places& places,
                      Problems& problems);

}  // namespace tolman::config
