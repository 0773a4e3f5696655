// SPDX-License-Identifier: BSD-3-Clause
// report.html and the figures of runs, as files.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "record/run_reader.hpp"
#include "report/drawn_units.hpp"
#include "report/run_data.hpp"
#include "tolman/status.hpp"

namespace tolman::run {

/// Writes report.html, figures/*.svg and *.png, and figures/neurons.json into `folder`, each
/// atomically; with several runs the figures go to figures/RUN. Each run is evaluated by the
/// settings in its own resolved configuration. Returns the files, the page first. InvalidParameter
/// if a run does not have the chosen units.
Result<std::vector<std::filesystem::path>> writeReport(
    const std::vector<std::unique_ptr<record::RunReader>>& runs,
    const std::filesystem::path& folder, const report::UnitChoice& units = {});

/// The same for one run whose record has been read already: writes into the directory of the run,
/// and no PNG files. `run_file`: text of the run.json that will be written after the report.
Status writeReport(const record::RunReader& reader, report::RunData data,
                   const std::string& run_file);

}  // namespace tolman::run
