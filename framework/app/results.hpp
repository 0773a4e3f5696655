// SPDX-License-Identifier: BSD-3-Clause
// From a recorded run to its result files: trajectories, map, metrics, digests.
#pragma once

#include <filesystem>

#include "config/settings.hpp"
#include "evaluation/metrics.hpp"
#include "tolman/status.hpp"

namespace tolman::app {

/// From run.sqlite alone writes trajectory.*, odometry.*, map.g2o, metrics.json, map.svg and
/// results.sha256 into `directory`; returns the figures.
Result<evaluation::Metrics> writeResults(const std::filesystem::path& directory,
                                         const config::EvaluationSettings& settings);

}  // namespace tolman::app
