// SPDX-License-Identifier: BSD-3-Clause
// How `tolman eval` scores one estimate: its options, and what they make of two trajectories.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/score.hpp"
#include "evaluation/step_series.hpp"

namespace tolman::app {

/// As they are given; empty ones follow the habit.
struct EvalOptions {
  std::string like = "tolman";
  std::string align;
  std::string scale;
  std::string up;
  std::string match;
  std::string offset;
  std::string body;
  std::string pairs = "all";
  std::string path_of;
  std::vector<std::string> rpe;
  std::size_t first = 0;
  double max_difference = -1;  ///< s
  double from = -1;            ///< s
  double until = -1;           ///< s
  bool path = false;

  void addTo(CLI::App& command);
  /// For readTrajectory().
  bool readsMatrices() const;
};

/// The figures of one estimate, and what was found on the way.
struct Evaluated {
  evaluation::Protocol protocol;
  evaluation::TrajectoryMetrics metrics;
  std::vector<std::string> warnings;             ///< about the matching
  std::optional<evaluation::ClockOffset> clock;  ///< where `--offset estimate` asked for it
  std::optional<evaluation::Extrinsic> body;     ///< where `--body` gave or asked for it
  /// Where the estimate starts again at its origin, its parts one by one.
  std::vector<evaluation::TrajectoryMetrics> parts;
};

/// `truth_name`, `name`: of the files, for messages. `doubts`: also what is wrong with them, and
/// the parts. Fails as commands do.
Evaluated evaluate(const EvalOptions& options, const evaluation::Trajectory& truth,
                   const evaluation::Trajectory& estimate, const std::string& truth_name,
                   const std::string& name, bool doubts = true);

}  // namespace tolman::app
