// SPDX-License-Identifier: BSD-3-Clause
#include "png_chunks.hpp"

#include <algorithm>

#include "bytes.hpp"

namespace tolman::image_folders {
namespace {

constexpr std::size_t kAroundData = 12;  // length, name and CRC

}  // namespace

bool isPng(std::span<const std::uint8_t> bytes) {
  using namespace std::string_view_literals;
  return asText(bytes).starts_with("\x89PNG\r\n\x1a\n"sv);
}

std::string_view PngChunk::name() const { return asText(bytes).substr(4, 4); }

std::span<const std::uint8_t> PngChunk::data() const {
  return bytes.subspan(8, bytes.size() - kAroundData);
}

std::uint32_t PngChunk::crc() const {
  return static_cast<std::uint32_t>(bigEndian(bytes, bytes.size() - 4, 4));
}

PngChunk pngChunkAt(std::span<const std::uint8_t> png, std::size_t at) {
  if (at + kAroundData > png.size()) return {};
  const auto length = static_cast<std::size_t>(bigEndian(png, at, 4));
  if (length > png.size() - at - kAroundData) return {};
  return {png.subspan(at, length + kAroundData)};
}

void removeExtras(std::vector<std::uint8_t>& png) {
  std::size_t end = kPngSignature;
  std::size_t at = kPngSignature;
  for (PngChunk chunk; !(chunk = pngChunkAt(png, at)).bytes.empty(); at += chunk.bytes.size()) {
    constexpr std::uint8_t kAncillary = 0x20;
    const bool extra = (chunk.bytes[4] & kAncillary) != 0 && chunk.name() != "tRNS";
    if (extra) continue;
    const bool is_last = chunk.name() == "IEND";
    if (end != at) {
      std::copy(chunk.bytes.begin(), chunk.bytes.end(), png.begin() + static_cast<long>(end));
    }
    end += chunk.bytes.size();
    if (is_last) break;
  }
  png.resize(end);
}

}  // namespace tolman::image_folders
