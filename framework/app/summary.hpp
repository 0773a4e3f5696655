// SPDX-License-Identifier: BSD-3-Clause
// The summary of a run on the terminal: health counters first, then the errors.
#pragma once

#include <string>
#include <string_view>

#include "app/program.hpp"
#include "engine/run.hpp"
#include "evaluation/metrics.hpp"

namespace tolman::app {

/// One block of health counters.
std::string healthText(const engine::Outcome& outcome);

/// The figures of one trajectory; `name` heads the first line.
std::string trajectoryText(std::string_view name, const evaluation::TrajectoryMetrics& metrics);

/// One line: where the truth is measured.
std::string bodyText(const evaluation::Extrinsic& body);

/// One line: errors of ring and grid modules against the truth; empty where nothing is known.
std::string cellsText(const evaluation::CellFigures& cells);

/// Prints how a run ended, and returns the exit code.
ExitCode printOutcome(const engine::Outcome& outcome, const Invocation& invocation);

}  // namespace tolman::app
