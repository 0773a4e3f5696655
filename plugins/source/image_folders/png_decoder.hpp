// SPDX-License-Identifier: BSD-3-Clause
// Decodes PNG data that may be damaged.
//
// Grey images of 8 bits, and colour ones if colour is requested, are inflated by libdeflate, which
// takes half the time of zlib. It needs all data in memory and gives all rows at once. Then the
// filters of the rows are undone here (ISO/IEC 15948, section 9). All other kinds and damaged
// images are decoded by OpenCV.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tolman/image.hpp"
#include "tolman/status.hpp"
#include "value_widths.hpp"

namespace tolman::image_folders {

/// Of the values of an image of 16 bits per channel.
struct DeepValues {
  int largest = -1;             ///< -1: the image has 8 bits
  std::size_t beyond_bits = 0;  ///< number of those that exceed `bits`
  /// Filled in if it has a value: it costs a millisecond for each half a million values.
  std::optional<source_parameters::ValueWidths> widths;
};

/// The same pixels as OpenCV's decoder, as Gray8, or as Bgr8 if `colour`. Of 16 bits per channel
/// the lowest `bits` are used, and of these the 8 highest become the pixel; larger values become
/// 255. `values`, if given, is filled in. Removes chunks from `png` that do not
/// affect pixels. The message of a failure completes the sentence "FILE ...".
Result<Image> decodePng(std::vector<std::uint8_t>& png, bool colour, int bits = 16,
                        DeepValues* values = nullptr);

/// Values of one channel of 16 bits, row by row. The message of a failure completes the sentence
/// "FILE ...".
Result<std::vector<std::uint16_t>> decodeDeepPng(std::vector<std::uint8_t>& png);

/// Only the fast way, by libdeflate; nullopt for other kinds of images and for damaged ones.
std::optional<Image> decodePlainPng(std::span<const std::uint8_t> png, bool colour);

}  // namespace tolman::image_folders
