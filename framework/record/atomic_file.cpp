// SPDX-License-Identifier: BSD-3-Clause
#include "record/atomic_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace tolman::record {
namespace {

Status failure(const std::string& shown, const std::string& what) {
  return Status::failed(shown + ": " + what + " (" + std::generic_category().message(errno) + ")");
}

bool writeAll(int file, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

/// Creates a new temporary file beside any that a killed program has left. `name` becomes its name.
FileDescriptor createTemporary(const FileDescriptor& directory, std::string& name) {
  constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const std::string candidate = "." + name + ".partial" + std::to_string(attempt);
    FileDescriptor file(::openat(directory.number(), candidate.c_str(), kFlags, 0644));
    if (file.isOpen() || errno != EEXIST) {
      name = candidate;
      return file;
    }
  }
  return FileDescriptor(-1);
}

}  // namespace

FileDescriptor::~FileDescriptor() {
  if (number_ >= 0) ::close(number_);
}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

FileDescriptor lockFolder(const std::filesystem::path& folder) {
  FileDescriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  const bool locked = descriptor.isOpen() && ::flock(descriptor.number(), LOCK_EX | LOCK_NB) == 0;
  return locked ? std::move(descriptor) : FileDescriptor(-1);
}

Status writeAtomicallyAt(const FileDescriptor& directory, const std::string& name,
                         std::span<const std::byte> bytes, const std::string& shown, Sync sync) {
  std::string temporary = name;
  const FileDescriptor file = createTemporary(directory, temporary);
  if (!file.isOpen()) return failure(shown, "cannot be created; check folder and permissions");
  Status status;
  const bool synced = sync == Sync::Yes;
  if (!writeAll(file.number(), bytes) || (synced && ::fsync(file.number()) != 0)) {
    status = failure(shown, "cannot be written; look for a full disk");
  } else if (::renameat(directory.number(), temporary.c_str(), directory.number(), name.c_str()) !=
             0) {
    status = failure(shown, "cannot be replaced");
  }
  if (!status.isOk()) ::unlinkat(directory.number(), temporary.c_str(), 0);
  return status;
}

Status writeAtomically(const std::filesystem::path& file, std::string_view text, Sync sync) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const FileDescriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!directory.isOpen())
    return failure(file.string(), "its folder cannot be opened; check path and permissions");
  return writeAtomicallyAt(directory, file.filename().string(),
                           std::as_bytes(std::span(text.data(), text.size())), file.string(), sync);
}

bool isStandardOutput(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::equivalent(file, "/proc/self/fd/1", ignored);
}

Status writeOutput(const std::filesystem::path& file, std::string_view text) {
  std::error_code ignored;
  const bool is_standard = isStandardOutput(file);
  if (!is_standard && !std::filesystem::is_other(file, ignored)) return writeAtomically(file, text);
  constexpr int kFlags =
      O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;  // does not wait for a reader
  const FileDescriptor stream(is_standard ? ::dup(STDOUT_FILENO) : ::open(file.c_str(), kFlags));
  if (!stream.isOpen()) {
    return failure(file.string(), errno == ENXIO ? "nobody reads this pipe; start its reader first"
                                                 : "cannot be opened; check its permissions");
  }
  if (!is_standard) ::fcntl(stream.number(), F_SETFL, O_WRONLY);
  if (writeAll(stream.number(), std::as_bytes(std::span(text.data(), text.size())))) return {};
  return failure(file.string(), "cannot be written; look for a full disk or a closed pipe");
}

}  // namespace tolman::record
