// SPDX-License-Identifier: BSD-3-Clause
#include "record/atomic_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

namespace tolman::record {
namespace {

namespace fs = std::filesystem;

Status failure(const fs::path& file, const std::string& what) {
  return Status::failed(file.string() + ": " + what + " (" +
                        std::generic_category().message(errno) + ")");
}

bool writeAll(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool isSafe(const fs::path& name) {
  if (name.empty() || name.is_absolute() || !name.has_filename()) return false;
  if (name.native().find('\0') != std::string::npos) return false;
  return std::ranges::none_of(
      name, [](const fs::path& part) { return part == ".." || part == "." || part.empty(); });
}

}  // namespace

FileDescriptor lockFolder(const fs::path& folder) {
  FileDescriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  const bool locked = descriptor.isOpen() && ::flock(descriptor.number(), LOCK_EX | LOCK_NB) == 0;
  return locked ? std::move(descriptor) : FileDescriptor(-1);
}

Status writeAtomically(const fs::path& file, std::string_view bytes, Sync sync) {
  const fs::path temporary = file.parent_path() / ("." + file.filename().string() + ".partial" +
                                                   std::to_string(::getpid()));
  const FileDescriptor stream(
      ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (!stream.isOpen()) return failure(file, "cannot be created; check folder and permissions");
  Status status;
  if (!writeAll(stream.number(), bytes) || (sync == Sync::Yes && ::fsync(stream.number()) != 0)) {
    status = failure(file, "cannot be written; look for a full disk");
  } else if (std::rename(temporary.c_str(), file.c_str()) != 0) {
    status = failure(file, "cannot be replaced");
  }
  if (!status.isOk()) ::unlink(temporary.c_str());
  return status;
}

bool isStandardOutput(const fs::path& file) {
  std::error_code ignored;
  return fs::equivalent(file, "/proc/self/fd/1", ignored);
}

Status writeOutput(const fs::path& file, std::string_view bytes) {
  std::error_code ignored;
  const bool is_standard = isStandardOutput(file);
  if (!is_standard && !fs::is_other(file, ignored)) return writeAtomically(file, bytes);
  constexpr int kFlags =
      O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;  // does not wait for a reader
  const FileDescriptor stream(is_standard ? ::dup(STDOUT_FILENO) : ::open(file.c_str(), kFlags));
  if (!stream.isOpen()) {
    return failure(file, errno == ENXIO ? "nobody reads this pipe; start its reader first"
                                        : "cannot be opened; check its permissions");
  }
  if (!is_standard) ::fcntl(stream.number(), F_SETFL, O_WRONLY);
  if (writeAll(stream.number(), bytes)) return {};
  return failure(file, "cannot be written; look for a full disk or a closed pipe");
}

Status writeOutputs(const std::vector<OutputFile>& files) {
  for (const auto& [path, bytes] : files) {
    if (Status status = writeOutput(path, bytes); !status.isOk()) return status;
  }
  return Status::ok();
}

fs::path truePath(const fs::path& path) {
  // Of a relative path that does not exist weakly_canonical() makes a relative one.
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  if (error) return path;
  const fs::path found = fs::weakly_canonical(absolute, error);
  const fs::path normal = error ? absolute.lexically_normal() : found;
  return normal.has_filename() ? normal : normal.parent_path();
}

bool isInside(const fs::path& path, const fs::path& folder) {
  const fs::path inner = truePath(path);
  const fs::path outer = truePath(folder);
  return !outer.empty() && std::ranges::mismatch(outer, inner).in1 == outer.end();
}

Status ArtefactFolder::write(std::string_view name, std::span<const std::byte> bytes) {
  const fs::path relative(name);
  if (!isSafe(relative) || !isSafe(instance_)) {
    return Status::invalidParameter("artefact '" + std::string(name) +
                                    "': the name must be relative, without \"..\"");
  }
  const fs::path file = run_directory_ / "artefacts" / instance_ / relative;
  std::error_code error;  // the write below fails with a message
  if (fs::is_directory(run_directory_, error)) fs::create_directories(file.parent_path(), error);
  return writeAtomically(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace tolman::record
