// SPDX-License-Identifier: BSD-3-Clause
// From a recorded run to its result files: trajectories, map, metrics, digests.
#pragma once

#include <filesystem>
#include <variant>

#include "app/exit_code.hpp"
#include "config/settings.hpp"
#include "evaluation/metrics.hpp"
#include "tolman/status.hpp"

namespace tolman::app {

/// The figures of the run in `directory`, from run.sqlite alone.
Result<evaluation::Metrics> measure(const std::filesystem::path& directory,
                                    const config::EvaluationSettings& settings);

/// Writes trajectory.*, odometry.*, map.g2o, metrics.json and results.sha256; returns the figures.
Result<evaluation::Metrics> writeResults(const std::filesystem::path& directory,
                                         const config::EvaluationSettings& settings);

}  // namespace tolman::app
