// SPDX-License-Identifier: BSD-3-Clause
// What a person reads after a run: health first, then the errors.
#pragma once

#include <string>
#include <string_view>

#include "evaluation/metrics.hpp"
#include "pipeline/run.hpp"

namespace tolman::app {

/// One block of health counters.
std::string healthText(const pipeline::Outcome& outcome, double wall_seconds);

/// The figures of one trajectory; `name` heads the first line.
std::string trajectoryText(std::string_view name, const evaluation::TrajectoryMetrics& metrics);

/// The figures: alignment, coverage, ATE, drift, for odometry and map, and time per stage.
std::string figuresText(const evaluation::Metrics& metrics);

}  // namespace tolman::app
