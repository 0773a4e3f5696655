// SPDX-License-Identifier: BSD-3-Clause
// One self-contained HTML page about one run, or several side by side.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "config/tree.hpp"
#include "report/figures.hpp"
#include "report/run_data.hpp"

namespace tolman::report {

struct PageFigure {
  std::string file;  ///< name without extension, "error"
  std::string caption;
  std::string svg;
};

/// The contents of a page about one run.
struct RunPage {
  RunData data;
  std::string directory;  ///< name of the run directory, unique among the runs of one page
  std::vector<PageFigure> figures;
  nlohmann::ordered_json neurons;     ///< neuronsJson()
  nlohmann::ordered_json provenance;  ///< run.json; null where it is missing
  std::string config;                 ///< config.resolved.yaml
  bool killed = false;                ///< the run was killed
  config::Node settings{};            ///< of `config`; only for the comparison of several runs
};

/// Draws the figures of a run. InvalidParameter where it has no such unit.
Result<RunPage> makePage(const std::filesystem::path& directory, RunData data,
                         const UnitChoice& units = {});

/// The maps of several runs beside each other; empty for a single one.
std::string comparisonFigure(const std::vector<RunPage>& runs);

/// Metrics and settings that differ, a column for each run; empty for a single one.
std::string comparisonTable(const std::vector<RunPage>& runs);

/// The page. With several runs it begins with their comparison, then has a part for each.
std::string html(const std::vector<RunPage>& runs);

}  // namespace tolman::report
