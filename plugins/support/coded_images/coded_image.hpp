// SPDX-License-Identifier: BSD-3-Clause
// A PNG or JPEG image in memory, which may be damaged.
#pragma once

#include <cstdint>
#include <span>

#include "tolman/image.hpp"
#include "tolman/status.hpp"
#include "used_bits.hpp"

namespace tolman::coded_images {

/// As Gray8, or as Bgr8 if `colour`; values of 16 bits by `bits`. The orientation in EXIF data does
/// not change the pixels, because a calibration is of the pixels as stored. InvalidInput for a
/// damaged image: the message completes the sentence "FILE ...".
Result<Image> decodeImage(std::span<const std::uint8_t> bytes, bool colour,
                          source_parameters::UsedBits& bits);

/// The orientation that a camera has noted in EXIF data (CIPA DC-008, tag 0x0112): 1 (as stored) to
/// 8; 1 where there is none. Viewers turn or mirror an image of another orientation.
int orientationOf(std::span<const std::uint8_t> bytes);

}  // namespace tolman::coded_images
