// SPDX-License-Identifier: BSD-3-Clause
// A configured system: the host's settings and the stages in processing order.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "config/loader.hpp"
#include "config/settings.hpp"
#include "tolman/roles.hpp"

namespace tolman::config {

/// One stage. The plugin's parameters are not checked yet: that needs its schema.
struct StageConfig {
  Role role = Role::Source;
  std::string path;      ///< "odometry", "observers.0"
  std::string plugin;    ///< id
  std::string instance;  ///< unique in the system: `name`, else the role, for observers the plugin
  FailurePolicy on_failure = FailurePolicy::Stop;
  Isolation isolation = Isolation::None;
  Node given;  ///< the map as configured

  /// Where the plugin is named, for messages.
  Origin pluginOrigin() const;
};

/// One group of the host's own keys, checked.
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
  CheckSettings checks;
  RectificationSettings rectification;
  ImageSettings images;
  std::vector<Section> sections;    ///< the same values, with their origins
  std::vector<StageConfig> stages;  ///< source, odometry, place, cells, map, observers
  BaseFolders folders;
};

/// Calls visit("pipeline", config.pipeline), and so on for each group of the host's keys, in the
/// order in which they are written.
template <class Config, class Visit>
void visitSections(Config& config, const Visit& visit) {
  visit("pipeline", config.pipeline);
  visit("evaluation", config.evaluation);
  visit("record", config.record);
  visit("isolation", config.isolation);
  visit("checks", config.checks);
  visit("rectification", config.rectification);
  visit("images", config.images);
}

/// The roles of the stages that every system has, in processing order.
inline constexpr std::array kChain = {Role::Source, Role::Odometry, Role::Place, Role::Cells,
                                      Role::Map};

/// First step: everything except the plugins' parameters. Values with problems get their defaults;
/// such a system must not be run.
SystemConfig parse(const Loaded& loaded, Problems& problems);

/// Second step, for each stage: values of all parameters of its plugin.
ParameterValues check(const StageConfig& stage, const Schema& schema, const BaseFolders& folders,
                      Problems& problems);

/// Checked parameters by the name of the stage's instance.
using StageValues = std::map<std::string, ParameterValues, std::less<>>;

/// config.resolved.yaml: loading it gives the same values.
std::string resolvedYaml(const SystemConfig& config, const StageValues& values);

/// The same with the origin of each value in a comment, for `tolman check --explain`:
///   active_points: 2000                     # configs/a.yaml:4:13
std::string explain(const SystemConfig& config, const StageValues& values);

}  // namespace tolman::config
