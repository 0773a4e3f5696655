// SPDX-License-Identifier: BSD-3-Clause
// Files for other programs that run the frozen runs of a sweep: Slurm, GNU parallel, Snakemake.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment/planner.hpp"

namespace tolman::experiment {

/// Writes into the folder of the sweep:
///   slurm      runs-1.txt and runs-2.txt, one folder per line; array.sh, which runs one of them;
///              submit.sh, which submits an array of each list, the second after the first
///   parallel   commands-1.txt, commands-2.txt: lists of commands, the second after the first
///   snakemake  Snakefile
/// Runs of the second list take answers of runs of the first. `command` runs one folder.
Result<std::vector<std::filesystem::path>> writeJobFiles(const std::filesystem::path& sweep,
                                                         const std::string& name,
                                                         const std::vector<PlannedRun>& runs,
                                                         const std::vector<std::string>& command,
                                                         const std::string& kind);

/// The names of the files that writeJobFiles() writes for this kind; none for an empty one.
std::vector<std::string> jobFileNames(const std::string& kind);

}  // namespace tolman::experiment
