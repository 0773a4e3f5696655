// SPDX-License-Identifier: BSD-3-Clause
#include "record/data_digest.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <system_error>
#include <utility>
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

void add(std::vector<DataFile>& files, const fs::path& path, const fs::path& root) {
  DataFile file{path == root ? "" : path.lexically_relative(root).string(), path, {}};
  if (::stat(path.c_str(), &file.status) != 0 || !S_ISREG(file.status.st_mode)) return;
  files.push_back(std::move(file));
  if (files.size() > kMostFiles) {
    throw fs::filesystem_error("walk", root, std::make_error_code(std::errc::file_too_large));
  }
}

/// The folders from the root of a walk to the present one. A link to one of them is not followed,
/// because the walk would not end.
class Ancestors {
 public:
  explicit Ancestors(const fs::path& root) { enter(root, -1); }

  /// Enters a folder at this depth; false if it is one of its own ancestors.
  bool enter(const fs::path& folder, int depth) {
    struct stat status {};
    if (::stat(folder.c_str(), &status) != 0) return false;
    const std::pair id(status.st_dev, status.st_ino);
    path_.resize(static_cast<std::size_t>(depth + 1));
    if (std::ranges::find(path_, id) != path_.end()) return false;
    path_.push_back(id);
    return true;
  }

 private:
  std::vector<std::pair<dev_t, ino_t>> path_;
};

/// All regular files below `root`, or `root` itself if it is a file. Throws fs::filesystem_error.
std::vector<DataFile> filesOf(const fs::path& root) {
  std::vector<DataFile> files;
  if (!fs::is_directory(root)) {
    add(files, root, root);
    return files;
  }
  const bool is_run = fs::exists(root / "run.json");
  Ancestors ancestors(root);
  for (fs::recursive_directory_iterator at(root, fs::directory_options::follow_directory_symlink);
       at != fs::recursive_directory_iterator(); ++at) {
    const fs::path& path = at->path();
    std::error_code ignored;
    if (at->is_directory(ignored) && !ancestors.enter(path, at.depth())) {
      at.disable_recursion_pending();
    }
    const std::string name = path.lexically_relative(root).string();
    if (is_run && name != kAnswersFile && !name.starts_with("state/")) continue;
    add(files, path, root);
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
    if (error.code() == std::errc::file_too_large) {
      return Status::invalidInput(fmt::format(
          "{}: more than {} files; name the folder of one recording", path.string(), kMostFiles));
    }
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
