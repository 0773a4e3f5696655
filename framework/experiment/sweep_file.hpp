// SPDX-License-Identifier: BSD-3-Clause
// The file of a sweep, a base configuration and what varies (docs/experiments.md), and its points:
// one run each.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/loader.hpp"
#include "config/tree.hpp"

namespace tolman::experiment {

/// A value for a key of the configuration; a map for a whole stage.
struct Setting {
  std::string key;  ///< "cells.period"
  std::shared_ptr<const config::Node> value;
};

/// A factor that varies, and the label of its value in one point, for tables.
struct Factor {
  std::string name;
  std::string label;
};

/// A run that is made once, before the points that use it: source, odometry and place of another
/// configuration, whose answers are replayed; or a first session, whose map is continued.
struct FrontEnd {
  std::string label;
  bool is_session = false;
  /// File or name of a shipped configuration. For a session: the base of the sweep.
  std::shared_ptr<const config::Node> base;
  std::vector<Setting> settings;
};

/// One value of what varies.
struct Choice {
  std::vector<Factor> factors;
  std::vector<Setting> settings;
  std::shared_ptr<const FrontEnd> front_end;  ///< null: the front end of the base
};

using Axis = std::vector<Choice>;

/// Points with all of these labels are left out.
struct Exclusion {
  /// Factors, each with any of these labels.
  std::vector<std::pair<std::string, std::vector<std::string>>> conditions;
  config::Origin origin;
};

struct SweepFile {
  std::string file;
  std::string name;
  std::shared_ptr<const config::Node> base;
  std::vector<Setting> settings;  ///< for all points
  bool reuse = true;              ///< front ends that several points share are run once
  std::vector<Axis> axes;         ///< grid, list, random
  std::vector<Axis> repeats;      ///< sequences, seeds: of all points
  std::vector<Exclusion> exclude;
};

/// Adds all problems of the file to `problems`; if there are new ones, do not use the result.
SweepFile readSweep(const std::filesystem::path& file, const config::Environment& environment,
                    config::Problems& problems);

struct SweepPoint {
  std::string name;  ///< "period=75,sequence=00,seed=1"; unique
  std::vector<Factor> factors{};
  std::vector<Setting> settings{};
  std::shared_ptr<const FrontEnd> front_end{};
};

/// The product of all axes, each with all sequences and seeds, without the excluded points.
/// Problems: exclusions without effect, and a key that two axes vary.
std::vector<SweepPoint> pointsOf(const SweepFile& sweep, config::Problems& problems);

}  // namespace tolman::experiment
