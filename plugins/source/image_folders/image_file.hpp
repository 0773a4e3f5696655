// SPDX-License-Identifier: BSD-3-Clause
// Reads one PNG or JPEG file without trusting it.
//
// OpenCV decodes a truncated JPEG to a full-size image with a grey rest and no error, and believes
// any size that a header claims. So header and end marker are checked here, before it decodes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::image_folders {

struct ImageSize {
  int width = 0;   ///< px
  int height = 0;  ///< px
  bool operator==(const ImageSize&) const = default;
};

/// The size that the header claims, for bytes that begin and end as an image does.
Result<ImageSize> checkImageBytes(std::span<const std::uint8_t> bytes);

/// The same for a file. Messages name the file and the remedy.
Result<ImageSize> checkImageFile(const std::filesystem::path& file);

/// An image of the size `expected` as Gray8, or as Bgr8 when `colour`. The orientation of EXIF data
/// is ignored: calibration is of the pixels as stored.
Result<Image> readImageFile(const std::filesystem::path& file, bool colour, ImageSize expected);

/// What plain cv::imread makes of the file: the measure of how long decoding must take.
Result<Image> readUnchecked(const std::filesystem::path& file, bool colour);

}  // namespace tolman::image_folders
