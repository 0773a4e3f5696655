// SPDX-License-Identifier: BSD-3-Clause
// Are two runs the same? Digests of their results.
#pragma once

#include <filesystem>
#include <string>

#include "tolman/status.hpp"

namespace tolman::record {

Result<std::string> fileDigest(const std::filesystem::path& file);

/// SHA-256 of all recorded rows that a run must repeat: every table but `timing`, `event` (its
/// order and its times are the machine's) and `run`.
Result<std::string> databaseDigest(const std::filesystem::path& run_directory);

/// Writes results.sha256: the exported files that are there, in the format of `sha256sum -c`.
Status writeResultsDigest(const std::filesystem::path& run_directory);

}  // namespace tolman::record
