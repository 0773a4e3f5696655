// SPDX-License-Identifier: BSD-3-Clause
// The files of a run directory: which of them Tolman writes, and their removal. Other files belong
// to the user and are kept.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "tolman/status.hpp"

namespace tolman::record {

/// The figures of a report: files of these names, as SVG and PNG.
inline constexpr std::array<std::string_view, 10> kFigureNames = {
    "map",    "error",  "elevation", "templates", "activity",
    "arrays", "firing", "units",     "timing",    "comparison"};

/// Name of a file in a run's folder `artefacts`. It lists the artefacts that the run has written,
/// each ended by a zero byte.
inline constexpr std::string_view kArtefactList = ".tolman-artefacts";

/// Whether `directory` is a run directory: it has a run.sqlite, a run.json with a status or beside
/// a config.resolved.yaml, or nothing but an empty log.txt.
bool holdsRun(const std::filesystem::path& directory);

/// The same, without the state in which only an empty log was written: `> log.txt` makes it in any
/// folder.
bool holdsRecordedRun(const std::filesystem::path& directory);

/// Removes what `export`, `report` or the end of a run computed from the record: trajectories, map,
/// metrics, figures, run.npz, run.nwb and the exports of earlier sessions. Files that Tolman does
/// not write are kept, and added to `kept` if they are in a folder of derived files. Failed if a
/// file cannot be removed, or if one of the folders is a link to another folder.
Status removeDerivedFiles(const std::filesystem::path& directory,
                          std::vector<std::filesystem::path>& kept);

/// The same for all files of a run, including record, log, states and artefacts.
Status removeRunFiles(const std::filesystem::path& directory,
                      std::vector<std::filesystem::path>& kept);

}  // namespace tolman::record
