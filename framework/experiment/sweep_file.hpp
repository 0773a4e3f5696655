// SPDX-License-Identifier: BSD-3-Clause
// Points of the unit cube for random and Sobol' sweeps.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "config/loader.hpp"
#include "config/tree.hpp"

namespace tolman::experiment {

inline constexpr std::size_t kSobolDimensions = 10;

/// The first points of Sobol's sequence in the order of the Gray code (Antonov and Saleev 1979),
/// with the direction numbers of Joe and Kuo (2008). At most kSobolDimensions dimensions.
std::vector<std::vector<double>> sobolPoints(std::size_t count, std::size_t dimensions);

/// Independent uniform points.
std::vector<std::vector<double>> randomPoints(std::size_t count, std::size_t dimensions,
                                              std::uint64_t seed);

// The file of a sweep: a base configuration and what varies. docs/experiments.md describes it.

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
  struct FactorLabels {
    std::string factor;
    std::vector<std::string> labels;  ///< any of them
  };
  std::vector<FactorLabels> conditions;
  config::Origin origin;
};

struct SweepFile {
  std::string file;
  std::string name;
  std::shared_ptr<const config::Node> base;
  std::vector<Setting> settings;  ///< for all points
  bool reuse = true;              ///< front ends that several points share are run once
  std::vector<Axis> axes;         ///< grid, list, random, sobol
  Axis include;                   ///< further points beside the product of `axes`
  std::vector<Axis> repeats;      ///< sequences, seeds: of all points
  std::vector<Exclusion> exclude;
};

/// Adds all problems of the file to `problems`; if there are new ones, do not use the result.
SweepFile readSweep(const std::filesystem::path& file, const config::Environment& environment,
                    config::Problems& problems);

}  // namespace tolman::experiment
