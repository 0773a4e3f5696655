// SPDX-License-Identifier: BSD-3-Clause
// Reads one PNG or JPEG file, which may be damaged.
//
// OpenCV decodes a truncated JPEG to a full-size image with a grey remainder and no error, and
// accepts any size in a header. So header and end marker are checked here before decoding by
// jpeg_decoder.hpp and png_decoder.hpp.
//
// A damaged file is InvalidInput. A file that cannot be opened or read (permissions, too many open
// files, a failing disk) may be undamaged, so this is Failed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "png_decoder.hpp"
#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::image_folders {

struct ImageSize {
  int width = 0;   ///< px
  int height = 0;  ///< px
  bool operator==(const ImageSize&) const = default;
};

/// The size in the header, for bytes that begin and end like a PNG or JPEG file.
Result<ImageSize> checkImageBytes(std::span<const std::uint8_t> bytes);

struct ImageHeader {
  ImageSize size;
  int orientation = 1;  ///< see orientationOf()
};

/// The same for a file. Messages name the file and the remedy.
Result<ImageHeader> checkImageFile(const std::filesystem::path& file);

/// What is unusual in an image that was read.
struct ImageNotes {
  int orientation = 1;  ///< see orientationOf()
  DeepValues values;
};

/// An image of the size `expected` as Gray8, or as Bgr8 if `colour`; `bits` of 16 are used, see
/// decodePng(), also for widths of the values. The orientation in EXIF data does not change the
/// pixels, because the calibration is of the pixels as stored. `notes`, if given, is filled in.
Result<Image> readImageFile(const std::filesystem::path& file, bool colour, ImageSize expected,
                            int bits = 16, ImageNotes* notes = nullptr);

/// A PNG of one channel of 16 bits, of the size `expected`, row by row.
Result<std::vector<std::uint16_t>> readDepthFile(const std::filesystem::path& file,
                                                 ImageSize expected);

}  // namespace tolman::image_folders
