// SPDX-License-Identifier: BSD-3-Clause
// Digests of the input data of a sweep, kept in data.json, so that data that have not changed are
// read once.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "record/data_digest.hpp"
#include "tolman/status.hpp"

namespace tolman::experiment {

/// Digests by path; empty if there are none.
std::map<std::string, record::DataDigest> readKnownData(const std::filesystem::path& sweep);
Status writeKnownData(const std::filesystem::path& sweep,
                      const std::map<std::string, record::DataDigest>& data);

// The files of a sweep's archive: configurations, digests, results and the commands that run it
// again on another machine.

/// Writes into `folder`, which must be empty or new:
///   rerun.sh     repeats all runs that are done, and compares the results byte for byte
///   data.txt     one line per input: variable, path, SHA-256 (or digest of sizes and times)
///   results.csv  the table of `tolman sweep collect`
///   runs/NAME/   config.resolved.yaml, run.json, metrics.json, results.sha256, point.json
///
/// In the configurations the paths of data are variables, with the present path as default.
Status writeSweepArchive(const std::filesystem::path& sweep, const std::filesystem::path& folder);

}  // namespace tolman::experiment
