// SPDX-License-Identifier: BSD-3-Clause
#include "orientation.hpp"

#include <cstddef>
#include <string_view>

#include "bytes.hpp"
#include "png_chunks.hpp"

namespace tolman::image_folders {
namespace {

using namespace std::string_view_literals;
using Bytes = std::span<const std::uint8_t>;

constexpr int kAsStored = 1;

/// A number in the byte order of a TIFF structure; 0 beyond its end.
std::size_t numberAt(Bytes tiff, std::size_t at, std::size_t count) {
  if (at > tiff.size() || count > tiff.size() - at) return 0;
  const bool is_big = tiff[0] == 'M';
  std::size_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    value = value * 256 + tiff[at + (is_big ? i : count - 1 - i)];
  }
  return value;
}

/// The orientation in the first directory of a TIFF structure.
int orientationIn(Bytes tiff) {
  constexpr std::size_t kTag = 0x0112;
  constexpr std::size_t kEntry = 12;
  const bool is_tiff = asText(tiff).starts_with("II*\0"sv) || asText(tiff).starts_with("MM\0*"sv);
  if (!is_tiff) return kAsStored;
  const std::size_t directory = numberAt(tiff, 4, 4);
  const std::size_t entries = numberAt(tiff, directory, 2);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + i * kEntry;
    if (numberAt(tiff, entry, 2) != kTag) continue;
    const std::size_t value = numberAt(tiff, entry + 8, 2);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : kAsStored;
  }
  return kAsStored;
}

int orientationInPng(Bytes png) {
  std::size_t at = kPngSignature;
  for (PngChunk chunk; !(chunk = pngChunkAt(png, at)).bytes.empty(); at += chunk.bytes.size()) {
    if (chunk.name() == "eXIf") return orientationIn(chunk.data());
  }
  return kAsStored;
}

int orientationInJpeg(Bytes jpeg) {
  constexpr std::string_view kExif = "Exif\0\0"sv;
  std::size_t at = 2;
  while (at + 4 <= jpeg.size() && jpeg[at] == 0xff && jpeg[at + 1] != 0xda) {
    const auto length = static_cast<std::size_t>(bigEndian(jpeg, at + 2, 2));
    if (length < 2 || length > jpeg.size() - at - 2) return kAsStored;
    const Bytes data = jpeg.subspan(at + 4, length - 2);
    if (jpeg[at + 1] == 0xe1 && asText(data).starts_with(kExif)) {
      return orientationIn(data.subspan(kExif.size()));
    }
    at += 2 + length;
  }
  return kAsStored;
}

}  // namespace

int orientationOf(Bytes image) {
  return isPng(image) ? orientationInPng(image) : orientationInJpeg(image);
}

}  // namespace tolman::image_folders
