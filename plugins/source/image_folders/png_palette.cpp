// SPDX-License-Identifier: BSD-3-Clause
#include "png_palette.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include "bytes.hpp"
#include "png_chunks.hpp"
#include "png_filters.hpp"
#include "png_inflate.hpp"

namespace tolman::image_folders {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// One pass over an image: from a first pixel on, every `column_step`-th of every `row_step`-th
/// row.
struct Pass {
  std::size_t first_column, first_row, column_step, row_step;
};
constexpr std::array kOnePass = {Pass{0, 0, 1, 1}};
constexpr std::array kInterlaced = {Pass{0, 0, 8, 8}, Pass{4, 0, 8, 8}, Pass{0, 4, 4, 8},
                                    Pass{2, 0, 4, 4}, Pass{0, 2, 2, 4}, Pass{1, 0, 2, 2},
                                    Pass{0, 1, 1, 2}};

/// Header, number of colours and data of an image with a palette.
struct PalettePng {
  std::size_t width = 0;
  std::size_t height = 0;
  std::size_t depth = 0;  ///< bits per index
  std::size_t colours = 0;
  std::span<const Pass> passes = kOnePass;
  std::vector<std::uint8_t> packed;

  std::size_t columns(const Pass& pass) const {
    return stepsTo(width, pass.first_column, pass.column_step);
  }
  std::size_t rows(const Pass& pass) const {
    return stepsTo(height, pass.first_row, pass.row_step);
  }
  std::size_t rowBytes(const Pass& pass) const { return (columns(pass) * depth + 7) / 8; }
  /// Bytes of all rows of a pass, each with one more byte for its filter.
  std::size_t size(const Pass& pass) const {
    return columns(pass) == 0 ? 0 : rows(pass) * (rowBytes(pass) + 1);
  }
  std::size_t size() const {
    std::size_t sum = 0;
    for (const Pass& pass : passes) sum += size(pass);
    return sum;
  }

 private:
  static std::size_t stepsTo(std::size_t end, std::size_t first, std::size_t step) {
    return end > first ? (end - first + step - 1) / step : 0;
  }
};

/// `depth` stays 0 for images without a palette.
void readPaletteHeader(Bytes header, PalettePng& image) {
  constexpr std::uint8_t kPalette = 3;
  if (header.size() != 13 || header[9] != kPalette) return;
  image.width = static_cast<std::size_t>(bigEndian(header, 0, 4));
  image.height = static_cast<std::size_t>(bigEndian(header, 4, 4));
  const std::uint8_t depth = header[8];
  if (depth == 1 || depth == 2 || depth == 4 || depth == 8) image.depth = depth;
  if (header[12] == 1) image.passes = kInterlaced;
}

PalettePng readPalettePng(Bytes png) {
  PalettePng image;
  std::size_t at = kPngSignature;
  for (PngChunk chunk; !(chunk = pngChunkAt(png, at)).bytes.empty(); at += chunk.bytes.size()) {
    const Bytes data = chunk.data();
    if (chunk.name() == "IHDR") readPaletteHeader(data, image);
    if (image.depth == 0) break;  // no palette, as in most images: nothing else is read
    if (chunk.name() == "PLTE") image.colours = data.size() / 3;
    if (image.colours >= std::size_t{1} << image.depth) break;
    if (chunk.name() == "IDAT") image.packed.insert(image.packed.end(), data.begin(), data.end());
  }
  return image;
}

/// Whether one of the indices in the rows of a pass is `image.colours` or more.
bool exceeds(const std::vector<std::uint8_t>& rows, const PalettePng& image, const Pass& pass) {
  const std::size_t per_byte = 8 / image.depth;
  const unsigned mask = (1U << image.depth) - 1;
  for (std::size_t r = 0; r < image.rows(pass); ++r) {
    for (std::size_t c = 0; c < image.columns(pass); ++c) {
      const unsigned byte = rows[r * image.rowBytes(pass) + c / per_byte];
      const std::size_t shift = 8 - image.depth * (1 + c % per_byte);
      if (((byte >> shift) & mask) >= image.colours) return true;
    }
  }
  return false;
}

}  // namespace

bool exceedsPalette(Bytes png) {
  const PalettePng image = readPalettePng(png);
  if (image.depth == 0 || image.colours >= std::size_t{1} << image.depth) return false;
  const auto data = inflatePng(image.packed, image.size());
  const std::uint8_t* filtered = data.get();
  if (filtered == nullptr) return false;
  for (const Pass& pass : image.passes) {
    if (image.size(pass) == 0) continue;
    std::vector<std::uint8_t> rows(image.rows(pass) * image.rowBytes(pass));
    if (!undoFilters(filtered, image.rows(pass), image.rowBytes(pass), 1, rows.data()))
      return false;
    if (exceeds(rows, image, pass)) return true;
    filtered += image.size(pass);
  }
  return false;
}

}  // namespace tolman::image_folders
