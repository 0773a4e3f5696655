// SPDX-License-Identifier: BSD-3-Clause
#include "scratch_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace tolman {
namespace {

/// Opens a file without a name; -1 and errno on failure.
int unnamedFile() {
  std::error_code error;
  std::string name = (std::filesystem::temp_directory_path(error) / "tolman-XXXXXX").string();
  if (error) {
    errno = error.value();
    return -1;
  }
  const int file = mkostemp(name.data(), O_CLOEXEC);
  if (file >= 0) unlink(name.c_str());
  return file;
}

Status failure(int code) {
  const std::string reason = code == 0 ? "it is too short" : std::generic_category().message(code);
  return Status::failed(reason +
                        "; does the folder for temporary files (TMPDIR) exist, and is it full?");
}

/// Calls `transfer(done)`, which returns as read() and write() do, until `size` bytes are done.
template <class Transfer>
Status transferAll(std::size_t size, Transfer&& transfer) {
  for (std::size_t done = 0; done < size;) {
    errno = 0;
    const ssize_t count = transfer(done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return failure(errno);
    done += static_cast<std::size_t>(count);
  }
  return Status::ok();
}

}  // namespace

ScratchFile::~ScratchFile() {
  if (file_ >= 0) close(file_);
}

Status ScratchFile::write(std::int64_t offset, std::span<const std::byte> bytes) {
  if (file_ < 0) file_ = unnamedFile();
  if (file_ < 0) return failure(errno);
  return transferAll(bytes.size(), [&](std::size_t done) {
    return pwrite(file_, bytes.data() + done, bytes.size() - done,
                  offset + static_cast<std::int64_t>(done));
  });
}

Status ScratchFile::read(std::int64_t offset, std::span<std::byte> bytes) const {
  return transferAll(bytes.size(), [&](std::size_t done) {
    return pread(file_, bytes.data() + done, bytes.size() - done,
                 offset + static_cast<std::int64_t>(done));
  });
}

}  // namespace tolman
