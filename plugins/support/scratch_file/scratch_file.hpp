// SPDX-License-Identifier: BSD-3-Clause
// A file without a name in the folder for temporary files (TMPDIR), for data that a plugin reads
// seldom and need not hold in memory. It is created at the first write, and the system removes it
// with the object, also when the process is killed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <tolman/status.hpp>
#include <utility>

namespace tolman {

/// Not thread-safe. Messages contain the system's reason; the caller adds what the file is for.
class ScratchFile {
 public:
  ScratchFile() = default;
  ~ScratchFile();
  ScratchFile(ScratchFile&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  ScratchFile& operator=(ScratchFile&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }

  /// Writes all of `bytes` at `offset`. After a failure the bytes there are undefined.
  Status write(std::int64_t offset, std::span<const std::byte> bytes);
  /// Fills `bytes` from `offset`; fails if the file is too short.
  Status read(std::int64_t offset, std::span<std::byte> bytes) const;

 private:
  int file_ = -1;
};

}  // namespace tolman
