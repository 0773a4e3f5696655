// SPDX-License-Identifier: BSD-3-Clause
// The files that a run reads, their digests, and whether they are still the same.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "tolman/status.hpp"

namespace tolman::record {

struct DataDigest {
  std::string path;
  std::int64_t files = 0;
  std::int64_t bytes = 0;
  std::string stamp;   ///< SHA-256 of names, inodes, sizes and modification times of all files
  std::string sha256;  ///< SHA-256 of names and contents of all files; empty above the limit
};

/// The digest of a file, or of all regular files below a folder. Of a run directory only the files
/// that a later run reads: run.sqlite and the state; run directories further below are left out,
/// because they are results, and not part of the data beside them. Links are followed, but not to a
/// folder that contains them. Contents are not read if `known` has the same path and stamp (then
/// `known` is returned), or if there are more than `most` bytes. InvalidInput if something cannot
/// be read, or for more than a million files.
Result<DataDigest> digestData(const std::filesystem::path& path, const DataDigest& known = {},
                              std::int64_t most = std::int64_t{64} << 30U);

}  // namespace tolman::record
