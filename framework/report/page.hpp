// SPDX-License-Identifier: BSD-3-Clause
// One self-contained HTML page about one run, or several side by side.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/drawn_units.hpp"
#include "report/run_data.hpp"

namespace tolman::report {

struct Figure {
  std::string file;  ///< name without extension, "error"
  std::string caption;
  std::string svg;
};

/// All that a page says about one run.
struct RunPage {
  RunData data;
  std::string directory;  ///< its name, without the path; tells the runs of one page apart
  std::vector<Figure> figures;
  /// What the firing figure shows in numbers: every unit's, and the rate maps that are drawn.
  nlohmann::ordered_json neurons;     ///< null without cells
  nlohmann::ordered_json provenance;  ///< run.json; null where it is missing
  std::string config;                 ///< config.resolved.yaml
  bool killed = false;                ///< it came to no end
};

/// Draws every figure that the record has something for. `reader` is of the run that `data` was
/// read from. InvalidParameter where the run has no such unit.
Result<RunPage> makePage(const record::RunReader& reader, RunData data,
                         const UnitChoice& units = {});
/// The same from the record alone.
Result<RunPage> makePage(const std::filesystem::path& directory,
                         const config::EvaluationSettings& settings, const UnitChoice& units = {});

/// The maps of several runs beside each other; empty for a single one.
std::string comparisonFigure(const std::vector<RunPage>& runs);

/// `comparison` is what comparisonFigure() has drawn of the same runs.
std::string html(const std::vector<RunPage>& runs, const std::string& comparison);
inline std::string html(const std::vector<RunPage>& runs) {
  return html(runs, comparisonFigure(runs));
}

}  // namespace tolman::report
