// SPDX-License-Identifier: BSD-3-Clause
// Random access to the bytes of one file of a ROS bag. A file that is compressed as a whole
// (zstd) is unpacked in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

#include "bytes.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_bag {

using ros_messages::Bytes;

class FileBytes {
 public:
  /// InvalidInput with the path and a remedy if the file cannot be read.
  static Result<FileBytes> open(const std::filesystem::path& path);

  std::uint64_t size() const { return size_; }
  /// Fills `bytes` from position `at` on; false if the file is too short.
  bool read(std::uint64_t at, std::span<std::uint8_t> bytes);
  /// Whether the file was unpacked in memory; memory() then has all its bytes.
  bool inMemory() const { return in_memory_; }
  Bytes memory() const { return memory_; }

 private:
  std::ifstream stream_;
  std::uint64_t size_ = 0;
  bool in_memory_ = false;
  std::vector<std::uint8_t> memory_;
};

// Decompression of Zstandard and LZ4 frames and bzip2 streams, with a limit that does not depend on
// the size in their headers.

using ros_messages::Bytes;

/// Whether the bytes begin as a Zstandard frame does.
bool isZstd(Bytes packed);

/// Empty if the data are damaged, incomplete or larger than `most` bytes.
std::optional<std::vector<std::uint8_t>> unpackZstd(Bytes packed, std::size_t most);
std::optional<std::vector<std::uint8_t>> unpackLz4(Bytes packed, std::size_t most);
std::optional<std::vector<std::uint8_t>> unpackBz2(Bytes packed, std::size_t most);

}  // namespace tolman::ros_bag
