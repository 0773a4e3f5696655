// SPDX-License-Identifier: BSD-3-Clause
#include "record/data_digest.hpp"

#include <fmt/format.h>

#include <system_error>
#include <vector>

#include "record/data_files.hpp"
#include "record/digest.hpp"
#include "record/sha256.hpp"

namespace tolman::record {

namespace fs = std::filesystem;

Result<DataDigest> digestData(const fs::path& path, const DataDigest& known, std::int64_t most) {
  std::vector<DataFile> files;
  try {
    files = dataFiles(path);
  } catch (const fs::filesystem_error& error) {
    if (error.code() == std::errc::file_too_large) {
      return Status::invalidInput(fmt::format(
          "{}: more than {} files; name the folder of one recording", path.string(), kMaxFiles));
    }
    return Status::invalidInput(error.path1().string() + ": " + error.code().message());
  }
  DataDigest digest;
  digest.path = path.string();
  digest.files = static_cast<std::int64_t>(files.size());
  Sha256 stamp;
  for (const DataFile& file : files) {
    digest.bytes += file.status.st_size;
    stamp.add(file.stamp());
  }
  digest.stamp = stamp.digest();
  if (known.path == digest.path && known.stamp == digest.stamp) return known;
  if (digest.bytes > most) return digest;
  Sha256 contents;
  for (const DataFile& file : files) {
    const auto one = fileDigest(file.path);
    if (!one.isOk()) return one.status();
    contents.add(one.value() + "  " + file.name + "\n");
  }
  digest.sha256 = contents.digest();
  return digest;
}

}  // namespace tolman::record
