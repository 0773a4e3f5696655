// SPDX-License-Identifier: BSD-3-Clause
#include "coded_image.hpp"

#include <algorithm>
#include <string_view>

#include "jpeg_decoder.hpp"
#include "png_decoder.hpp"

namespace tolman::coded_images {
namespace {

using namespace std::string_view_literals;

/// A number of a TIFF structure ("II": little-endian, "MM": big-endian); 0 beyond its end.
std::size_t tiffNumber(std::string_view tiff, std::size_t at, std::size_t bytes) {
  if (at > tiff.size() || bytes > tiff.size() - at) return 0;
  std::size_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    const std::size_t next = at + (tiff[0] == 'M' ? i : bytes - 1 - i);
    value = value * 256 + static_cast<std::uint8_t>(tiff[next]);
  }
  return value;
}

}  // namespace

Result<Image> decodeImage(std::span<const std::uint8_t> bytes, bool colour,
                          source_parameters::UsedBits& bits) {
  if (bytes.empty()) return Status::invalidInput("is empty");
  if (isPng(bytes)) return decodePng(bytes, colour, bits);
  if (bytes.size() > 1 && bytes[0] == 0xff && bytes[1] == 0xd8) return decodeJpeg(bytes, colour);
  return Status::invalidInput("is neither a PNG nor a JPEG image");
}

int orientationOf(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kBegin = std::size_t{1} << 16U;  // cameras write it before the pixels
  const std::string_view begin(reinterpret_cast<const char*>(bytes.data()),
                               std::min(bytes.size(), kBegin));
  const std::string_view mark = isPng(bytes) ? "eXIf"sv : "Exif\0\0"sv;
  const std::size_t found = begin.find(mark);
  if (found == std::string_view::npos) return 1;
  const std::string_view tiff = begin.substr(found + mark.size());
  if (!tiff.starts_with("II*\0"sv) && !tiff.starts_with("MM\0*"sv)) return 1;
  const std::size_t directory = tiffNumber(tiff, 4, 4);
  const std::size_t entries = tiffNumber(tiff, directory, 2);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t entry = directory + 2 + 12 * i;
    if (tiffNumber(tiff, entry, 2) != 0x0112) continue;
    const std::size_t value = tiffNumber(tiff, entry + 8, 2);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
  }
  return 1;
}

}  // namespace tolman::coded_images
