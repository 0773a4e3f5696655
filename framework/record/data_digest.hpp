// SPDX-License-Identifier: BSD-3-Clause
// The files that a run reads, their digests, and whether they are still the same.
#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tolman/status.hpp"

namespace tolman::record {

inline constexpr std::size_t kMaxFiles = 1'000'000;
inline constexpr std::int64_t kMaxData = std::int64_t{64} << 30U;  // bytes

struct DataFile {
  std::string name;  ///< relative to the path that was given; empty for a single file
  std::filesystem::path path;
  struct stat status {};

  /// Name, device, inode, size and time of modification, as one line.
  std::string stamp() const;
};

/// The regular files below `root` by name, or `root` itself if it is a file. Of a run directory
/// only the files that a later run reads: run.sqlite and the state; run directories further below
/// are left out, because they are results, and not part of the data beside them. Links are
/// followed, but not to a folder that contains them. Throws std::filesystem::filesystem_error,
/// for more than kMaxFiles files with std::errc::file_too_large.
std::vector<DataFile> dataFiles(const std::filesystem::path& root);

struct DataDigest {
  std::string path;
  std::int64_t files = 0;
  std::int64_t bytes = 0;
  std::string stamp;   ///< SHA-256 of names, inodes, sizes and modification times of all files
  std::string sha256;  ///< SHA-256 of names and contents of all files; empty above the limit
};

/// The digest of a file, or of all dataFiles() below a folder. Contents are not read if `known` has
/// the same path and stamp (then `known` is returned), or if there are more than `most` bytes.
/// InvalidInput if something cannot be read, or for more than kMaxFiles files.
Result<DataDigest> digestData(const std::filesystem::path& path, const DataDigest& known = {},
                              std::int64_t most = kMaxData);

}  // namespace tolman::record
