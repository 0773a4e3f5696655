// SPDX-License-Identifier: BSD-3-Clause
#include "record/data_digest.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include "record/atomic_file.hpp"
#include "record/digest.hpp"

namespace tolman::record {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFiles = 1'000'000;

struct DataFile {
  std::string name;  ///< relative to the path that was given; empty for a single file
  fs::path path;
  struct stat status {};

  /// Name, device, inode, size and time of modification, as one line.
  std::string stamp() const {
    return fmt::format("{}\n{} {} {} {} {}\n", name, status.st_dev, status.st_ino, status.st_size,
                       status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
  }
};

void add(std::vector<DataFile>& files, const fs::path& path, const fs::path& root) {
  DataFile file{path == root ? "" : path.lexically_relative(root).string(), path, {}};
  if (::stat(path.c_str(), &file.status) != 0 || !S_ISREG(file.status.st_mode)) return;
  files.push_back(std::move(file));
  if (files.size() > kMaxFiles) {
    throw fs::filesystem_error("walk", root, std::make_error_code(std::errc::file_too_large));
  }
}

bool isRun(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / "run.json", ignored);
}

/// By name. Throws fs::filesystem_error.
std::vector<DataFile> dataFiles(const fs::path& root) {
  std::vector<DataFile> files;
  if (!fs::is_directory(root)) {
    add(files, root, root);
    return files;
  }
  const bool is_run = isRun(root);
  for (fs::recursive_directory_iterator at(root, fs::directory_options::follow_directory_symlink);
       at != fs::recursive_directory_iterator(); ++at) {
    const fs::path& path = at->path();
    std::error_code ignored;
    const bool leads_back = at->is_symlink(ignored) && isInside(path.parent_path(), path);
    if (at->is_directory(ignored) && (isRun(path) || leads_back)) at.disable_recursion_pending();
    const std::string name = path.lexically_relative(root).string();
    if (is_run && name != "run.sqlite" && !name.starts_with("state/")) continue;
    add(files, path, root);
  }
  std::ranges::sort(files, {}, &DataFile::name);
  return files;
}

}  // namespace

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
