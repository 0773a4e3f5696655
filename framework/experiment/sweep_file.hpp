// SPDX-License-Identifier: BSD-3-Clause
// The file of a sweep: a base configuration and what varies. docs/experiments.md describes it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "config/node.hpp"
#include "config/variables.hpp"

namespace tolman::experiment {

/// A value for a key of the configuration; a map for a whole stage.
struct Setting {
  std::string key;  ///< "cells.period"
  std::shared_ptr<const config::Node> value;
};

/// What varies, and its value in one point, as tables show it.
struct Factor {
  std::string name;
  std::string label;
};

/// A run before points, made once: source, odometry and place of a configuration of its own, whose
/// answers are replayed; or a first session, whose map is continued.
struct FrontEnd {
  std::string label;
  bool is_session = false;
  /// File, or the name of a shipped configuration; of a session that of the sweep, with its `set`.
  std::shared_ptr<const config::Node> base;
  std::vector<Setting> settings;
};

/// One value of what varies.
struct Choice {
  std::vector<Factor> factors;
  std::vector<Setting> settings;
  std::shared_ptr<const FrontEnd> front_end;  ///< null: that of the base
};

using Axis = std::vector<Choice>;

/// Points with all of these labels are left out.
struct Exclusion {
  struct Condition {
    std::string factor;
    std::vector<std::string> labels;  ///< any of them
  };
  std::vector<Condition> conditions;
  config::Origin origin;
};

struct SweepFile {
  std::string file;
  std::string name;
  std::shared_ptr<const config::Node> base;
  std::vector<Setting> settings;  ///< of all points
  bool reuse = true;              ///< front ends that several points share are run once
  std::vector<Axis> axes;         ///< grid, list, random, sobol
  Axis include;                   ///< further points beside the product of `axes`
  std::vector<Axis> repeats;      ///< sequences, seeds: of all points
  std::vector<Exclusion> exclude;
};

/// All problems of the file are added to `problems`; with new ones the result is not to be used.
SweepFile readSweep(const std::filesystem::path& file, const config::Environment& environment,
                    config::Problems& problems);

}  // namespace tolman::experiment
