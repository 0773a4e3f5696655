// SPDX-License-Identifier: BSD-3-Clause
// Bilinear interpolation at the places of a PixelMap: one by one, or eight neighbours at once where
// the processor has SSE4.1. Both give the same bytes, as both count in whole numbers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tolman/image.hpp"

namespace tolman::imaging {

/// Parts of a pixel that places are rounded to.
constexpr int kParts = 64;

/// Where one pixel comes from.
struct Place {
  static constexpr std::uint8_t kNowhere = 255;

  std::uint16_t x = 0;  ///< the pixel above and left of the place
  std::uint16_t y = 0;
  std::uint8_t right = kNowhere;  ///< share of the pixels to the right, in 1/64
  std::uint8_t below = 0;
};

/// Eight neighbours of a row. They come from at most 16 columns of the raw image, or `rows` is 0.
struct PixelGroup {
  std::uint16_t x = 0;       ///< first column
  std::uint16_t y = 0;       ///< first row
  std::uint32_t rows = 0;    ///< that upper pixels come from
  std::uint8_t column[8]{};  // NOLINT(modernize-avoid-c-arrays): loaded as one word
  std::uint8_t row[8]{};     // NOLINT(modernize-avoid-c-arrays)
  std::uint8_t right[8]{};   // NOLINT(modernize-avoid-c-arrays)
  std::uint8_t below[8]{};   // NOLINT(modernize-avoid-c-arrays)
};

/// The groups of one row of places; a last one of fewer than eight is left out.
void groupPlaces(std::span<const Place> places, int raw_width, PixelGroup* groups);

/// Whether groups can be used.
bool hasGroupInstructions();

/// Interpolates a row; `groups` null: one by one. Pixels from nowhere stay as they are (black).
void interpolateRow(const Image& raw, std::span<const Place> places, const PixelGroup* groups,
                    std::uint8_t* out);

}  // namespace tolman::imaging
