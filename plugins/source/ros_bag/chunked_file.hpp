// SPDX-License-Identifier: BSD-3-Clause
// Common part of the formats whose messages are single records or in compressed chunks.
#pragma once

#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "bag_file.hpp"
#include "file_bytes.hpp"

namespace tolman::ros_bag {

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
