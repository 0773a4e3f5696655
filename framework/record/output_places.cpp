// SPDX-License-Identifier: BSD-3-Clause
#include "record/output_places.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "record/atomic_file.hpp"
#include "record/run_files.hpp"

namespace tolman::record {
namespace {

namespace fs = std::filesystem;

/// Whether the folder of the file is there and may be changed.
Status checkFolderOf(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_other(file, ignored) || isStandardOutput(file)) return Status::ok();
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const bool is_folder = fs::is_directory(folder, ignored);
  if (is_folder && ::access(folder.c_str(), W_OK | X_OK) == 0) return Status::ok();
  const int why = is_folder ? errno : fs::exists(folder, ignored) ? ENOTDIR : ENOENT;
  return Status::failed(file.string() + ": its folder cannot be " +
                        (is_folder ? "written" : "opened") + "; check path and permissions (" +
                        std::generic_category().message(why) + ")");
}

}  // namespace

fs::path truePath(const fs::path& path) {
  // Of a relative path that does not exist weakly_canonical() makes a relative one.
  std::error_code failure;
  const fs::path absolute = fs::absolute(path, failure);
  if (failure) return path;
  const fs::path found = fs::weakly_canonical(absolute, failure);
  const fs::path normal = failure ? absolute.lexically_normal() : found;
  return normal.has_filename() ? normal : normal.parent_path();
}

Status refuseLinks(const fs::path& directory, std::span<const std::string_view> folders) {
  std::error_code ignored;
  for (const std::string_view name : folders) {
    if (!fs::is_symlink(directory / name, ignored)) continue;
    return Status::failed((directory / name).string() +
                          ": is a link to another folder; remove it, or choose another --out");
  }
  return Status::ok();
}

Status refuseFolders(const std::vector<fs::path>& files, const std::string& option) {
  std::error_code ignored;
  for (const fs::path& file : files) {
    if (!fs::is_directory(fs::symlink_status(file, ignored))) continue;
    return Status::failed(file.string() + ": is a folder, and a file is to be written there; " +
                          "remove it, or choose another " + option);
  }
  return Status::ok();
}

std::optional<fs::path> runAround(const fs::path& path) {
  const fs::path inner = truePath(path);
  for (fs::path outer = inner.parent_path(); outer.has_relative_path();
       outer = outer.parent_path()) {
    if (holdsRecordedRun(outer)) return outer;
  }
  return std::nullopt;
}

Status refuseRunPlaces(const fs::path& path, const std::string& option, const fs::path& own) {
  const std::optional<fs::path> run = runAround(path);
  if (!run) return Status::ok();
  std::error_code ignored;
  if (!own.empty() && fs::equivalent(own, *run, ignored)) {
    const fs::path first = *truePath(path).lexically_relative(*run).begin();
    if (std::ranges::find(kRunFolders, first.string()) == kRunFolders.end()) return Status::ok();
    return Status::failed(path.string() + ": lies in " + (*run / first).string() +
                          ", whose files belong to the run alone; choose another " + option);
  }
  return Status::failed(path.string() + ": lies in the directory of the run " + run->string() +
                        ", whose files belong to that run alone; choose another " + option);
}

Status writeTogether(const std::vector<OutputFile>& files, const std::string& option) {
  std::vector<fs::path> paths;
  for (const OutputFile& file : files) paths.push_back(file.path);
  Status status = refuseFolders(paths, option);
  for (const fs::path& path : paths) {
    if (status.isOk()) status = checkFolderOf(path);
  }
  for (const OutputFile& file : files) {
    if (status.isOk()) status = writeOutput(file.path, file.bytes);
  }
  return status;
}

}  // namespace tolman::record
