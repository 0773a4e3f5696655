// SPDX-License-Identifier: BSD-3-Clause
// A file without a name: what is on it needs no memory, and is gone with the process.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tolman::web_viewer {

/// All functions throw std::system_error when the disk refuses.
class TemporaryFile {
 public:
  /// In the system's folder for temporary files ($TMPDIR).
  TemporaryFile();
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::uint64_t offset, std::span<const char> bytes);
  void read(std::uint64_t offset, std::span<char> bytes) const;
  /// Gives the blocks back to the disk; false where the file system cannot.
  bool release(std::uint64_t offset, std::uint64_t size);

 private:
  int descriptor_ = -1;
};

}  // namespace tolman::web_viewer
