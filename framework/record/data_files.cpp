// SPDX-License-Identifier: BSD-3-Clause
#include "record/data_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "record/answers_file.hpp"
#include "record/output_places.hpp"

namespace tolman::record {
namespace {

namespace fs = std::filesystem;

void add(std::vector<DataFile>& files, const fs::path& path, const fs::path& root) {
  DataFile file{path == root ? "" : path.lexically_relative(root).string(), path, {}};
  if (::stat(path.c_str(), &file.status) != 0 || !S_ISREG(file.status.st_mode)) return;
  files.push_back(std::move(file));
  if (files.size() > kMaxFiles) {
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

bool isRun(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / "run.json", ignored);
}

}  // namespace

std::string DataFile::stamp() const {
  return fmt::format("{}\n{} {} {} {} {}\n", name, status.st_dev, status.st_ino, status.st_size,
                     status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
}

std::vector<DataFile> dataFiles(const fs::path& root) {
  std::vector<DataFile> files;
  if (!fs::is_directory(root)) {
    add(files, root, root);
    return files;
  }
  const bool is_run = isRun(root);
  Ancestors ancestors(root);
  for (fs::recursive_directory_iterator at(root, fs::directory_options::follow_directory_symlink);
       at != fs::recursive_directory_iterator(); ++at) {
    const fs::path& path = at->path();
    std::error_code ignored;
    if (at->is_directory(ignored) && (isRun(path) || !ancestors.enter(path, at.depth()))) {
      at.disable_recursion_pending();
    }
    const std::string name = path.lexically_relative(root).string();
    if (is_run && name != kAnswersFile && !name.starts_with("state/")) continue;
    add(files, path, root);
  }
  std::ranges::sort(files, {}, &DataFile::name);
  return files;
}

fs::path firstChanged(const std::vector<DataFile>& files) {
  for (DataFile file : files) {
    const std::string before = file.stamp();
    if (::stat(file.path.c_str(), &file.status) != 0 || file.stamp() != before) return file.path;
  }
  return {};
}

bool isInside(const std::filesystem::path& path, const std::filesystem::path& folder) {
  const auto inner = truePath(path);
  const auto outer = truePath(folder);
  return !outer.empty() && std::ranges::mismatch(outer, inner).in1 == outer.end();
}

}  // namespace tolman::record
