// SPDX-License-Identifier: BSD-3-Clause
#include "record/artefacts.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <system_error>

#include "record/atomic_file.hpp"

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
