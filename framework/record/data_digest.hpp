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
  std::string stamp;   ///< SHA-256 of names, sizes and times of change of all files
  std::string sha256;  ///< of names and contents of all files; empty for more than the most
};

inline constexpr std::int64_t kMostData = std::int64_t{64} << 30U;  // bytes

/// Of a file, or of all regular files below a folder. Of a run directory the files that a later run
/// reads: answers.bin and the state. Contents are read only where `known` is not of the same path
/// and stamp, and of at most `most` bytes. InvalidInput where something cannot be read.
Result<DataDigest> digestData(const std::filesystem::path& path, const DataDigest& known = {},
                              std::int64_t most = kMostData);

}  // namespace tolman::record
