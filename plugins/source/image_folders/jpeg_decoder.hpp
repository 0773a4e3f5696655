// SPDX-License-Identifier: BSD-3-Clause
// Decodes JPEG data that may be damaged.
//
// OpenCV ignores the warnings of libjpeg, which goes on after a damaged Huffman code and returns a
// full-size image with a wrong remainder. Here the first such warning is a failure. JPEG has no
// check sum, so a change that happens to be legal code stays unseen.
#pragma once

#include <cstdint>
#include <span>

#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::image_folders {

/// The pixels as OpenCV's decoder gives them, as Gray8, or as Bgr8 when `colour`. A failure
/// completes the sentence "FILE ...".
Result<Image> decodeJpeg(std::span<const std::uint8_t> bytes, bool colour);

}  // namespace tolman::image_folders
