// SPDX-License-Identifier: BSD-3-Clause
#include "record/data_digest.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <vector>

#include "record/answers_file.hpp"
#include "record/digest.hpp"
#include "record/sha256.hpp"

namespace tolman::record {
namespace {

namespace fs = std::filesystem;

struct DataFile {
  std::string name;  ///< relative to the path that was given
  fs::path path;
  struct stat status {};
};

bool add(std::vector<DataFile>& files, const fs::path& path, const fs::path& root) {
  DataFile file{path == root ? "" : path.lexically_relative(root).string(), path, {}};
  if (::stat(path.c_str(), &file.status) != 0) return false;
  if (S_ISREG(file.status.st_mode)) files.push_back(std::move(file));
  return true;
}

/// Throws fs::filesystem_error.
std::vector<DataFile> filesOf(const fs::path& root) {
  std::vector<DataFile> files;
  if (!fs::is_directory(root)) {
    add(files, root, root);
    return files;
  }
  const bool is_run = fs::exists(root / "run.json");
  for (const auto& entry :
       fs::recursive_directory_iterator(root, fs::directory_options::follow_directory_symlink)) {
    const std::string name = entry.path().lexically_relative(root).string();
    if (is_run && name != kAnswersFile && !name.starts_with("state/")) continue;
    add(files, entry.path(), root);
  }
  std::ranges::sort(files, {}, &DataFile::name);
  return files;
}

}  // namespace

Result<DataDigest> digestData(const fs::path& path, const DataDigest& known, std::int64_t most) {
  std::vector<DataFile> files;
  try {
    files = filesOf(path);
  } catch (const fs::filesystem_error& error) {
    return Status::invalidInput(error.path1().string() + ": " + error.code().message());
  }
  DataDigest digest;
  digest.path = path.string();
  digest.files = static_cast<std::int64_t>(files.size());
  Sha256 stamp;
  for (const DataFile& file : files) {
    const struct stat& s = file.status;
    digest.bytes += s.st_size;
    stamp.add(fmt::format("{}\n{} {} {} {} {}\n", file.name, s.st_dev, s.st_ino, s.st_size,
                          s.st_mtim.tv_sec, s.st_mtim.tv_nsec));
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
