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
  std::span<const std::uint8_t> bytes;  ///< the whole chunk; empty: there is no chunk
  std::string_view name() const;
  std::span<const std::uint8_t> data() const;
  /// The CRC that is stored in the chunk.
  std::uint32_t crc() const;
};

inline constexpr std::size_t kPngSignature = 8;  // bytes before the first chunk

/// The chunk at `at`; empty if the file ends within it.
PngChunk pngChunkAt(std::span<const std::uint8_t> png, std::size_t at);

/// Removes chunks that do not affect pixels, such as comments and colour profiles: libpng allocates
/// memory of the size in their header, up to 2 GiB, before it reads them.
void removeExtras(std::vector<std::uint8_t>& png);

}  // namespace tolman::image_folders
