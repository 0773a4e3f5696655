// SPDX-License-Identifier: BSD-3-Clause
// Numbers at given places of a video container. Nothing is read beyond its end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>

namespace tolman::video {

class ContainerBytes {
 public:
  /// Of size 0 if the file cannot be read.
  explicit ContainerBytes(const std::filesystem::path& file);

  std::uint64_t size() const { return size_; }
  /// Fills `bytes` from `at` on; false beyond the end.
  bool read(std::uint64_t at, std::span<std::uint8_t> bytes);
  /// The big-endian number of `bytes` bytes, at most 8, at `at`; nullopt beyond the end.
  std::optional<std::uint64_t> number(std::uint64_t at, unsigned bytes);
  /// The CRC-32 (ISO/IEC 3309) of the bytes from `begin` to before `end`; nullopt beyond the end.
  std::optional<std::uint32_t> checkSum(std::uint64_t begin, std::uint64_t end);

 private:
  std::ifstream stream_;
  std::uint64_t size_ = 0;
};

}  // namespace tolman::video
