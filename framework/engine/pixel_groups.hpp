// SPDX-License-Identifier: BSD-3-Clause
// Bilinear interpolation at the positions of a PixelMap: one by one, or eight neighbours at once
// where the processor has SSE4.1. Both use integer arithmetic and give the same bytes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tolman/image.hpp"

namespace tolman::engine {

/// Positions are rounded to this fraction of a pixel: 1/64.
constexpr int kParts = 64;

/// The position in the raw image that one pixel is interpolated from.
struct RawPosition {
  static constexpr std::uint8_t kNowhere = 255;

  std::uint16_t x = 0;  ///< the pixel above and left of the position
  std::uint16_t y = 0;
  std::uint8_t right = kNowhere;  ///< share of the pixels to the right, in 1/64
  std::uint8_t below = 0;
};

/// Eight neighbours of a row. They come from at most 16 columns of the raw image, or `rows` is 0.
struct PixelGroup {
  std::uint16_t x = 0;       ///< first column
  std::uint16_t y = 0;       ///< first row
  std::uint32_t rows = 0;    ///< number of raw rows of the upper pixels
  std::uint8_t column[8]{};  // NOLINT(modernize-avoid-c-arrays): loaded as one word
  std::uint8_t row[8]{};     // NOLINT(modernize-avoid-c-arrays)
  std::uint8_t right[8]{};   // NOLINT(modernize-avoid-c-arrays)
  std::uint8_t below[8]{};   // NOLINT(modernize-avoid-c-arrays)
};

/// The groups of one row of positions; the last positions, if fewer than eight, are in no group.
void groupPositions(std::span<const RawPosition> positions, int raw_width, PixelGroup* groups);

/// Whether the processor supports groups.
bool hasGroupInstructions();

/// Interpolates a row; `groups` null: one by one. Pixels without a position are unchanged (black).
void interpolateRow(const Image& raw, std::span<const RawPosition> positions,
                    const PixelGroup* groups, std::uint8_t* out);

}  // namespace tolman::engine
