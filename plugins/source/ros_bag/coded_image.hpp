// SPDX-License-Identifier: BSD-3-Clause
// JPEG and PNG images in messages.
#pragma once

#include "bytes.hpp"
#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_bag {

struct ImageSize {
  int width = 0;   ///< px
  int height = 0;  ///< px
  bool operator==(const ImageSize&) const = default;
};

/// A size that an image can have; InvalidInput else.
Result<ImageSize> plausibleSize(std::uint64_t width, std::uint64_t height);

/// The size in the header, for bytes that begin and end as a JPEG or PNG file does.
Result<ImageSize> codedSize(Bytes coded);

/// Gray8, or Bgr8 when `colour`, of 8 or 16 bit. OpenCV would show a cut JPEG with a grey
/// remainder; the end is checked before.
Result<Image> decodeImage(Bytes coded, bool colour);

}  // namespace tolman::ros_bag
