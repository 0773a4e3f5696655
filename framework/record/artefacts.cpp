// SPDX-License-Identifier: BSD-3-Clause
#include "record/artefacts.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <system_error>

#include "record/atomic_file.hpp"
#include "record/run_files.hpp"

namespace tolman::record {
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

/// Appends `name`, relative to `artefacts`, to the list of the artefacts of the run.
Status addToList(const FileDescriptor& artefacts, const std::string& name,
                 const std::filesystem::path& shown) {
  const std::string list(kArtefactList);
  constexpr int kFlags = O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC;
  const FileDescriptor file(::openat(artefacts.number(), list.c_str(), kFlags, 0644));
  const std::size_t size = name.size() + 1;  // with the zero byte that ends it
  if (file.isOpen() && ::write(file.number(), name.c_str(), size) == static_cast<ssize_t>(size)) {
    return Status::ok();
  }
  return Status::failed((shown / list).string() + ": cannot be written (" +
                        std::generic_category().message(errno) + "); look for a full disk");
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
  if (folder.isOpen() && !listed_.contains(relative.string())) {
    const FileDescriptor all = enter(folder, artefacts.string());
    const std::string listed = (std::filesystem::path(instance_) / relative).string();
    const Status status =
        all.isOpen() ? addToList(all, listed, run_directory_ / artefacts) : Status::ok();
    if (!status.isOk()) return status;
    listed_.insert(relative.string());
  }
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
