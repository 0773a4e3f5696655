// SPDX-License-Identifier: BSD-3-Clause
#include "record/output_places.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "record/atomic_file.hpp"
#include "record/run_directory.hpp"

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

std::optional<fs::path> runAround(const fs::path& path) {
  const fs::path inner = truePath(path);
  for (fs::path outer = inner.parent_path(); outer.has_relative_path();
       outer = outer.parent_path()) {
    if (holdsRun(outer)) return outer;
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
  Status status;
  std::error_code ignored;
  for (const auto& [path, bytes] : files) {
    if (fs::is_directory(fs::symlink_status(path, ignored))) {
      return Status::failed(path.string() + ": is a folder, and a file is to be written there; " +
                            "remove it, or choose another " + option);
    }
    if (status.isOk()) status = checkFolderOf(path);
  }
  for (const OutputFile& file : files) {
    if (status.isOk()) status = writeOutput(file.path, file.bytes);
  }
  return status;
}

namespace {

bool isSafe(const std::filesystem::path& name) {
  if (name.empty() || name.is_absolute() || !name.has_filename()) return false;
  if (name.native().find('\0') != std::string::npos) return false;
  for (const auto& part : name) {
    if (part == ".." || part == "." || part.empty()) return false;
  }
  return true;
}

/// Opens the folder `name` in `parent`, and creates it if necessary; refuses a symbolic link.
FileDescriptor enter(const FileDescriptor& parent, const std::string& name) {
  ::mkdirat(parent.number(), name.c_str(), 0755);
  return FileDescriptor(
      ::openat(parent.number(), name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

}  // namespace

ArtefactFolder::ArtefactFolder(std::filesystem::path run_directory, std::string instance)
    : run_directory_(std::move(run_directory)), instance_(std::move(instance)) {}

Status ArtefactFolder::write(std::string_view name, std::span<const std::byte> bytes) {
  const std::filesystem::path relative(name);
  if (!isSafe(relative) || !isSafe(instance_)) {
    return Status::invalidParameter("artefact '" + std::string(name) +
                                    "': the name must be relative, without \"..\"");
  }
  const std::filesystem::path artefacts("artefacts");
  const std::filesystem::path path = artefacts / instance_ / relative;
  FileDescriptor folder(::open(run_directory_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  for (const auto& part : path.parent_path()) {
    if (folder.isOpen()) folder = enter(folder, part.string());
  }
  if (!folder.isOpen()) {
    return Status::failed((run_directory_ / path).string() + ": its folder cannot be used (" +
                          std::generic_category().message(errno) +
                          "); it must be a folder, not a link");
  }
  return writeAtomicallyAt(folder, path.filename().string(), bytes,
                           (run_directory_ / path).string());
}

}  // namespace tolman::record
