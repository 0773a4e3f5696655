// SPDX-License-Identifier: BSD-3-Clause
#include "container_bytes.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <system_error>
#include <vector>

namespace tolman::video {

ContainerBytes::ContainerBytes(const std::filesystem::path& file)
    : stream_(file, std::ios::binary) {
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(file, failure);
  if (stream_.is_open() && !failure) size_ = size;
}

bool ContainerBytes::read(std::uint64_t at, std::span<std::uint8_t> bytes) {
  if (at > size_ || bytes.size() > size_ - at) return false;
  stream_.clear();
  stream_.seekg(static_cast<std::streamoff>(at));
  stream_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return static_cast<bool>(stream_);
}

std::optional<std::uint64_t> ContainerBytes::number(std::uint64_t at, unsigned bytes) {
  std::array<std::uint8_t, sizeof(std::uint64_t)> read_bytes{};
  if (bytes > read_bytes.size() || !read(at, std::span(read_bytes).first(bytes)))
    return std::nullopt;
  std::uint64_t number = 0;
  for (const std::uint8_t byte : std::span(read_bytes).first(bytes)) number = (number << 8U) | byte;
  return number;
}

std::optional<std::uint32_t> ContainerBytes::checkSum(std::uint64_t begin, std::uint64_t end) {
  constexpr std::uint64_t kBlock = 1U << 16U;
  std::vector<std::uint8_t> block(kBlock);
  uLong sum = 0;
  while (begin < end) {
    const std::uint64_t size = std::min(kBlock, end - begin);
    if (!read(begin, std::span(block).first(size))) return std::nullopt;
    sum = crc32_z(sum, block.data(), size);
    begin += size;
  }
  return static_cast<std::uint32_t>(sum);
}

}  // namespace tolman::video
