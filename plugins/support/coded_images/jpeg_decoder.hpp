// SPDX-License-Identifier: BSD-3-Clause
// Decodes JPEG data that may be damaged.
//
// OpenCV ignores the warnings of libjpeg, which continues after a damaged Huffman code and returns
// a full-size image with a wrong remainder. Here the first such warning is a failure. JPEG has no
// checksum, so damage that is valid code is not detected.
#pragma once

#include <cstdint>
#include <span>

#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::coded_images {

/// The same pixels as OpenCV's decoder, as Gray8, or as Bgr8 if `colour`. The message of a failure
/// completes the sentence "FILE ...".
Result<Image> decodeJpeg(std::span<const std::uint8_t> bytes, bool colour);

}  // namespace tolman::coded_images
