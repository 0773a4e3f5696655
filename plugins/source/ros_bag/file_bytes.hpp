// SPDX-License-Identifier: BSD-3-Clause
// Bytes of the files of a bag.
//
// Random access to the bytes of one file of a ROS bag. A file that is compressed as a whole
// (zstd) is unpacked in memory.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

#include "bag.hpp"
#include "field_reader.hpp"
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

// Common part of the formats whose messages are single records or in compressed chunks.

class ChunkedFile : public BagFile {
 public:
  Result<std::vector<std::uint8_t>> read(const MessagePlace& place) final;

 protected:
  using Contents = std::vector<std::uint8_t>;
  /// Largest size of a record and of an unpacked chunk.
  static constexpr std::uint64_t kMaxBytes = std::uint64_t{256} << 20U;

  explicit ChunkedFile(FileBytes file) : file_(std::move(file)) {}
  FileBytes& file() { return file_; }
  /// Reads `size` bytes at `at`, of the record that begins at `record`. Of a failure the text
  /// completes the sentence "FILE ...".
  Result<Contents> readBytes(std::uint64_t at, std::uint64_t size, std::uint64_t record);
  /// The records of the chunk at `at`, read and unpacked.
  virtual Result<Contents> readChunk(std::uint64_t at) = 0;

 private:
  Result<const Contents*> chunkAt(std::uint64_t at);

  FileBytes file_;
  std::deque<std::pair<std::uint64_t, Contents>> chunks_;  ///< unpacked last, at most two
};

}  // namespace tolman::ros_bag
