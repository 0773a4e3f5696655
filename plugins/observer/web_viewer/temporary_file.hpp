// SPDX-License-Identifier: BSD-3-Clause
// A file without a name; the system deletes it when the process ends.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tolman::web_viewer {

/// All functions throw std::system_error on failure.
class TemporaryFile {
 public:
  /// Creates the file in the folder for temporary files ($TMPDIR).
  TemporaryFile();
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::uint64_t offset, std::span<const char> bytes);
  void read(std::uint64_t offset, std::span<char> bytes) const;
  /// Frees the blocks; false if the file system does not support this.
  bool release(std::uint64_t offset, std::uint64_t size);

 private:
  int descriptor_ = -1;
};

}  // namespace tolman::web_viewer
