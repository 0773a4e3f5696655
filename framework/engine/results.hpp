// SPDX-License-Identifier: BSD-3-Clause
// From recorded runs to their result files, figures and pages.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "config/system_config.hpp"
#include "record/run_reader.hpp"
#include "report/figures.hpp"
#include "report/run_data.hpp"
#include "tolman/status.hpp"

namespace tolman::engine {

/// The configuration of a recorded run; the defaults if it cannot be read.
config::SystemConfig configOf(const std::filesystem::path& run);

/// The data of the result files, for the report.
struct Results {
  std::unique_ptr<record::RunReader> reader;
  report::RunData data;
};

/// Writes trajectory.*, odometry.*, map.g2o, metrics.json, map.svg and results.sha256 into
/// `directory`, from run.sqlite alone. `seed`: seed of the run, for the scores by chance.
Result<Results> writeResults(const std::filesystem::path& directory,
                             const config::EvaluationSettings& settings, std::uint64_t seed);

/// The left images of frames of a run, for the pictures of its loops.
using ViewsOfRun = std::function<std::map<std::int64_t, Image>(const record::RunReader&,
                                                               const std::set<std::int64_t>&)>;

/// Writes report.html, figures/*.svg and *.png, and figures/neurons.json into `folder`, each
/// atomically; with several runs the figures go to figures/RUN. Each run is evaluated by the
/// settings in its own resolved configuration. Returns the files, the page first.
Result<std::vector<std::filesystem::path>> writeReport(
    const std::vector<std::unique_ptr<record::RunReader>>& runs,
    const std::filesystem::path& folder, const ViewsOfRun& views = {});

/// The same for one run whose record has been read already: writes into the directory of the run,
/// and no PNG files. `run_file`: text of the run.json that will be written after the report.
Status writeReport(const record::RunReader& reader, report::RunData data,
                   const std::string& run_file);

/// Short, distinct names of run directories: the last part of each path, after removing last parts
/// that all paths have in common: "a" and "b" for sweeps/a/run and sweeps/b/run. If two names are
/// equal, earlier parts are added, joined by '-', until all differ; a directory that is given twice
/// gets a number.
std::vector<std::string> distinctNames(const std::vector<std::filesystem::path>& runs);

}  // namespace tolman::engine
