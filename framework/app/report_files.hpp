// SPDX-License-Identifier: BSD-3-Clause
// report.html and the figures of runs, as files.
#pragma once

#include <filesystem>
#include <vector>

#include "record/run_reader.hpp"
#include "report/drawn_units.hpp"
#include "report/run_data.hpp"
#include "tolman/status.hpp"

namespace tolman::app {

/// Writes report.html, figures/*.svg and figures/neurons.json into `folder`, each atomically; of
/// several runs the figures stand in figures/RUN. Each run is evaluated as its own resolved
/// configuration says. Returns what was written, the page first. InvalidParameter where a run has
/// no such unit.
Result<std::vector<std::filesystem::path>> writeReport(
    const std::vector<std::filesystem::path>& runs, const std::filesystem::path& folder,
    const report::UnitChoice& units = {});

/// The same for one run whose record was read already, into its own directory. Without PNG: a run
/// should not wait for what few need.
Status writeReport(const record::RunReader& reader, report::RunData data);

}  // namespace tolman::app
