// SPDX-License-Identifier: BSD-3-Clause
// Bytes of an image file as text and as numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace tolman::image_folders {

inline std::string_view asText(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Big-endian number of `count` bytes at `at`; the caller has checked that they exist.
inline std::int64_t bigEndian(std::span<const std::uint8_t> bytes, std::size_t at,
                              std::size_t count) {
  std::int64_t value = 0;
  for (const std::uint8_t byte : bytes.subspan(at, count)) value = value * 256 + byte;
  return value;
}

}  // namespace tolman::image_folders
