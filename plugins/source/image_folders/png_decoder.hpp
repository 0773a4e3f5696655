// SPDX-License-Identifier: BSD-3-Clause
// Decodes PNG data that may be damaged.
//
// Grey images of 8 bits, and colour ones where colour is asked for, are inflated by libdeflate,
// which takes half the time of zlib; it needs the whole data in memory, and gives all rows at once.
// What is left of the format is undone here: the filters of the rows (ISO/IEC 15948, section 9).
// All other kinds, and all that is damaged, goes to OpenCV.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::image_folders {

/// The pixels as OpenCV's decoder gives them, as Gray8, or as Bgr8 when `colour`. Of 16 bits a
/// channel the lowest `bits` are used, and of these the 8 highest become the pixel; larger values
/// become 255. Removes chunks from `png` that pixels do not depend on. A failure completes the
/// sentence "FILE ...".
Result<Image> decodePng(std::vector<std::uint8_t>& png, bool colour, int bits = 16);

/// Values of one channel of 16 bits, row by row. A failure completes the sentence "FILE ...".
Result<std::vector<std::uint16_t>> decodeDeepPng(std::vector<std::uint8_t>& png);

/// The fast way alone; nullopt for other kinds of images and for damaged ones.
std::optional<Image> decodePlainPng(std::span<const std::uint8_t> png, bool colour);

}  // namespace tolman::image_folders
