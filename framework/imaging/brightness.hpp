// SPDX-License-Identifier: BSD-3-Clause
// How bright an image is, for hints where nothing is found in it.
#pragma once

#include "tolman/image.hpp"

namespace tolman::imaging {

/// A quarter of the grey levels. Images of 14 bits or fewer that are taken for 16 bits stay below.
inline constexpr int kNearlyBlack = 64;

/// The largest value of any channel, 0 to 255; -1 of an empty image.
int brightest(const Image& image);

/// Whether no value reaches kNearlyBlack. Not of an empty image.
inline bool isNearlyBlack(const Image& image) {
  return !image.empty() && brightest(image) < kNearlyBlack;
}

}  // namespace tolman::imaging
