// SPDX-License-Identifier: BSD-3-Clause
// The files of a sweep's archive: configurations, digests, results and the commands that run it
// again on another machine.
#pragma once

#include <filesystem>

#include "tolman/status.hpp"

namespace tolman::experiment {

/// Writes into `folder`, which must be empty or new:
///   rerun.sh          runs all runs that are done again, and compares the results byte for byte
///   data.txt          what the runs read: variable, path, SHA-256 (or sizes and times), a line
///   each results.csv       as of `tolman sweep collect` runs/NAME/        config.resolved.yaml,
///   run.json, metrics.json, results.sha256, point.json
/// In the configurations the paths of data are variables, with the path of now as default.
Status writeSweepArchive(const std::filesystem::path& sweep, const std::filesystem::path& folder);

}  // namespace tolman::experiment
