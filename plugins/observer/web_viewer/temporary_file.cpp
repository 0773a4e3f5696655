// SPDX-License-Identifier: BSD-3-Clause
#include "temporary_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace tolman::web_viewer {
namespace {

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

[[noreturn]] void failToCreate(const std::string& folder, const std::error_code& error) {
  const bool descriptors =
      error == std::errc::too_many_files_open || error == std::errc::too_many_files_open_in_system;
  throw std::system_error(
      error, folder + ": cannot hold temporary files; " +
                 (descriptors ? "allow more open files (`ulimit -n`)"
                              : "set TMPDIR to a folder that exists and can be written"));
}

}  // namespace

TemporaryFile::TemporaryFile() {
  std::error_code error;
  // Also of a folder that is none, the path is named.
  const char* given = std::getenv("TMPDIR");
  std::string folder = std::filesystem::temp_directory_path(error).string();
  if (error && given != nullptr) folder = given;
  if (error) failToCreate(folder, error);
  descriptor_ = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (descriptor_ >= 0) return;
  std::string name = folder + "/tolman-viewer-XXXXXX";  // no O_TMPFILE on this file system
  descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) failToCreate(folder, {errno, std::generic_category()});
  ::unlink(name.c_str());
}

TemporaryFile::~TemporaryFile() { ::close(descriptor_); }

void TemporaryFile::write(std::uint64_t offset, std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail("the temporary file cannot be written");
    bytes = bytes.subspan(static_cast<std::size_t>(n));
    offset += static_cast<std::uint64_t>(n);
  }
}

void TemporaryFile::read(std::uint64_t offset, std::span<char> bytes) const {
  while (!bytes.empty()) {
    const ssize_t n = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail("the temporary file cannot be read");
    bytes = bytes.subspan(static_cast<std::size_t>(n));
    offset += static_cast<std::uint64_t>(n);
  }
}

bool TemporaryFile::release(std::uint64_t offset, std::uint64_t size) {
  return ::fallocate(descriptor_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE,
                     static_cast<off_t>(offset), static_cast<off_t>(size)) == 0;
}

}  // namespace tolman::web_viewer
