// SPDX-License-Identifier: BSD-3-Clause
// SHA-256 of the results of a run, to compare runs byte by byte.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "tolman/status.hpp"

namespace tolman::record {

/// SHA-256 of a text or of the bytes of a file, as 64 hexadecimal digits.
std::string textDigest(std::string_view text);
Result<std::string> fileDigest(const std::filesystem::path& file);

/// Writes results.sha256: digests of the exported files that exist, in the format of `sha256sum
/// -c`.
Status writeResultsDigest(const std::filesystem::path& run_directory);

/// Digests that results.sha256 lists, by file; empty where there is none.
std::map<std::string, std::string> resultsDigests(const std::filesystem::path& run_directory);

/// The files that results.sha256 lists and that are not as it says. Files that were removed are
/// none of them: an archive has the digests without the files.
std::set<std::string> changedResults(const std::filesystem::path& run_directory);

}  // namespace tolman::record
