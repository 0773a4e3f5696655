// SPDX-License-Identifier: BSD-3-Clause
// The orientation that a camera has noted in an image file: tag 0x0112 of EXIF (CIPA DC-008), in a
// segment APP1 of JPEG or a chunk eXIf of PNG.
#pragma once

#include <cstdint>
#include <span>

namespace tolman::image_folders {

/// 1 (as stored) to 8; 1 where there is none, or none that can be read. Viewers turn or mirror an
/// image of another orientation before they show it.
int orientationOf(std::span<const std::uint8_t> image);

}  // namespace tolman::image_folders
