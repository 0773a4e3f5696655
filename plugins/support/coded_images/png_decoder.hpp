// SPDX-License-Identifier: BSD-3-Clause
// Decodes PNG data (ISO/IEC 15948), which may be damaged.
//
// Grey images of 8 bits, and colour ones if colour is requested, are inflated by libdeflate, which
// takes half the time of zlib. It needs all data in memory and gives all rows at once; the filters
// of the rows are then undone here. All other kinds, and damaged images, are decoded by OpenCV.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tolman/image.hpp"
#include "tolman/status.hpp"
#include "used_bits.hpp"

namespace tolman::coded_images {

bool isPng(std::span<const std::uint8_t> bytes);

/// The same pixels as OpenCV's decoder, as Gray8, or as Bgr8 if `colour`; those of 16 bits by
/// `bits`. The message of a failure completes the sentence "FILE ...".
Result<Image> decodePng(std::span<const std::uint8_t> png, bool colour,
                        source_parameters::UsedBits& bits);

/// A depth image: the values of one channel of 16 bits, row by row.
struct DepthValues {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> values;
};
Result<DepthValues> decodeDepth(std::span<const std::uint8_t> png);

/// Only the fast way, by libdeflate; nullopt for other kinds of images and for damaged ones.
std::optional<Image> decodePlainPng(std::span<const std::uint8_t> png, bool colour);

}  // namespace tolman::coded_images
