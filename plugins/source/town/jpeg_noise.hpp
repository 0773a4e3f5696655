// SPDX-License-Identifier: BSD-3-Clause
// The loss of baseline JPEG compression: quantised cosine coefficients of blocks of 8 x 8 pixels.
#pragma once

#include "tolman/image.hpp"

namespace tolman::town {

/// The image after compression at `quality` (1 to 100) with the luminance table of the standard's
/// annex K, with the usual scaling: at 50 the table is not scaled.
Image throughJpeg(const Image& image, int quality);

}  // namespace tolman::town
