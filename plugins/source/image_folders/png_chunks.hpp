// SPDX-License-Identifier: BSD-3-Clause
// The chunks of a PNG file: length, name, data and CRC (ISO/IEC 15948, section 5.3).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace tolman::image_folders {

bool isPng(std::span<const std::uint8_t> bytes);

/// A whole chunk, within the file.
struct PngChunk {
  std::span<const std::uint8_t> bytes;  ///< all of it; empty where there is none
  std::string_view name() const;
  std::span<const std::uint8_t> data() const;
  /// As the chunk says it.
  std::uint32_t crc() const;
};

inline constexpr std::size_t kPngSignature = 8;  // bytes before the first chunk

/// The chunk at `at`; an empty one where the file ends within it.
PngChunk pngChunkAt(std::span<const std::uint8_t> png, std::size_t at);

/// Removes chunks that pixels do not depend on, such as comments and colour profiles: libpng takes
/// memory of the size that they claim, up to 2 GiB, before it reads them.
void removeExtras(std::vector<std::uint8_t>& png);

}  // namespace tolman::image_folders
