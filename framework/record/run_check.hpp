// SPDX-License-Identifier: BSD-3-Clause
// Whether the files beside run.sqlite are those of the run: its configuration and its results.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tolman/status.hpp"

namespace tolman::record {

/// The key of run.json with the digest of config.resolved.yaml.
inline constexpr const char* kConfigDigest = "config_sha256";

/// InvalidInput if config.resolved.yaml is missing, or another than `run_file`, the contents of
/// run.json, has the digest of. Ok if that has none, as in records of older versions.
Status checkConfig(const std::filesystem::path& run_directory,
                   const nlohmann::ordered_json& run_file);

/// InvalidInput if files are missing that every run leaves when it ends, or that results.sha256
/// lists. Ok while a run goes on, and after one that was killed or has failed.
Status checkEndFiles(const std::filesystem::path& run_directory);

}  // namespace tolman::record
