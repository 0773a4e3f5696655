// SPDX-License-Identifier: BSD-3-Clause
// Digests of the files that a run reads.
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

inline constexpr std::int64_t kMaxData = std::int64_t{64} << 30U;  // bytes

/// The digest of a file, or of all dataFiles() below a folder. Contents are not read if `known` has
/// the same path and stamp (then `known` is returned), or if there are more than `most` bytes.
/// InvalidInput if something cannot be read, or for more than kMaxFiles files.
Result<DataDigest> digestData(const std::filesystem::path& path, const DataDigest& known = {},
                              std::int64_t most = kMaxData);

}  // namespace tolman::record
