// SPDX-License-Identifier: BSD-3-Clause
// Pixels of a PNG file with a palette that name a colour beyond its end. Decoders make them black;
// the standard calls them an error (ISO/IEC 15948, section 11.2.2).
#pragma once

#include <cstdint>
#include <span>

namespace tolman::image_folders {

/// False for images without a palette, with a palette of all colours, and with damaged data, which
/// the decoder reports.
bool exceedsPalette(std::span<const std::uint8_t> png);

}  // namespace tolman::image_folders
