// SPDX-License-Identifier: BSD-3-Clause
// How bright an image is, for hints where nothing is found in it.
#pragma once

#include "tolman/image.hpp"

namespace tolman::imaging {

/// A quarter of the grey levels. Images of 14 bits or fewer that are taken for 16 bits stay below.
inline constexpr int kNearlyBlack = 64;

/// The largest value of any channel, 0 to 255, where one in ten thousand values is left out,
/// because a hot pixel says nothing of the others; -1 of an empty image. The share is that by which
/// sources judge images of 16 bits (plugins/support/source_parameters/value_widths.hpp).
int brightest(const Image& image);

/// Whether hardly any value reaches kNearlyBlack, see brightest(). Not of an empty image.
inline bool isNearlyBlack(const Image& image) {
  return !image.empty() && brightest(image) < kNearlyBlack;
}

}  // namespace tolman::imaging
