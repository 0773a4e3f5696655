// SPDX-License-Identifier: BSD-3-Clause
// The files of a run directory: which of them Tolman writes, and their removal. The folders
// kRunFolders (output_places.hpp) belong to the run as a whole; beside them other files belong to
// the user and are kept.
#pragma once

#include <filesystem>

#include "tolman/status.hpp"

namespace tolman::record {

/// Whether `directory` is a run directory: it has a run.sqlite, a run.json with a status or beside
/// a config.resolved.yaml, or nothing but an empty log.txt.
bool holdsRun(const std::filesystem::path& directory);

/// The same, without the state in which only an empty log was written: `> log.txt` makes it in any
/// folder.
bool holdsRecordedRun(const std::filesystem::path& directory);

/// Removes what `export`, `report` or the end of a run computed from the record: trajectories, map,
/// metrics, figures, run.npz, run.nwb and the exports of earlier sessions. Failed if a file cannot
/// be removed.
Status removeDerivedFiles(const std::filesystem::path& directory);

/// The same for all files of a run, including record, log, states and artefacts.
Status removeRunFiles(const std::filesystem::path& directory);

}  // namespace tolman::record
