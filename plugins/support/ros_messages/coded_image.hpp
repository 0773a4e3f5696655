// SPDX-License-Identifier: BSD-3-Clause
// JPEG and PNG images in messages.
#pragma once

#include <algorithm>
#include <cstdint>

#include "bytes.hpp"
#include "tolman/image.hpp"
#include "tolman/status.hpp"
#include "value_widths.hpp"

namespace tolman::ros_messages {

struct ImageSize {
  int width = 0;   ///< px
  int height = 0;  ///< px
  bool operator==(const ImageSize&) const = default;
};

/// The size if an image can have it, otherwise InvalidInput.
Result<ImageSize> plausibleSize(std::uint64_t width, std::uint64_t height);

/// The size in the header, for bytes that begin and end as a JPEG or PNG file does.
Result<ImageSize> codedSize(Bytes coded);

/// Of images of 16 bits: how they become images of 8.
struct DeepPixels {
  int bits = 16;  ///< that are used, from the lowest; the 8 highest of them are taken
  source_parameters::ValueWidths widths = {};  ///< of the values that were converted

  std::uint8_t convert(int value) {
    widths.add(static_cast<std::uint16_t>(value));
    return static_cast<std::uint8_t>(std::min(value >> (bits - 8), 255));
  }
};

/// Decodes 8 or 16 bit to Gray8, or to Bgr8 if `colour`. Checks the end of the file first, because
/// OpenCV decodes a truncated JPEG with a grey remainder.
Result<Image> decodeImage(Bytes coded, bool colour, DeepPixels& deep);

}  // namespace tolman::ros_messages
