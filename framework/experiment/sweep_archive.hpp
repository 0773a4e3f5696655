// SPDX-License-Identifier: BSD-3-Clause
// The files of a sweep's archive: configurations, digests, results and the commands that run it
// again on another machine.
#pragma once

#include <filesystem>

#include "tolman/status.hpp"

namespace tolman::experiment {

/// Writes into `folder`, which must be empty or new:
///   rerun.sh     repeats all runs that are done, and compares the results byte for byte
///   data.txt     one line per input: variable, path, SHA-256 (or digest of sizes and times)
///   results.csv  the table of `tolman sweep collect`
///   runs/NAME/   config.resolved.yaml, run.json, metrics.json, results.sha256, point.json
///
/// In the configurations the paths of data are variables, with the present path as default.
Status writeSweepArchive(const std::filesystem::path& sweep, const std::filesystem::path& folder);

}  // namespace tolman::experiment
