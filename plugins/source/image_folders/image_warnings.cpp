// SPDX-License-Identifier: BSD-3-Clause
#include "image_warnings.hpp"

namespace tolman::image_folders {

std::optional<std::string> ImageWarnings::ofOrientation(int orientation) {
  const std::string number = std::to_string(orientation);
  if (!usual_) {
    usual_ = orientation;
    if (orientation == 1) return std::nullopt;
    return "is stored turned or mirrored (EXIF orientation " + number +
           "), and the pixels are used as stored: the axes of the camera are those of the stored "
           "image. If the calibration is of upright images, turn the files, such as with `exiftran "
           "-ai` or `jpegtran`";
  }
  if (orientation == *usual_ || is_change_told_) return std::nullopt;
  is_change_told_ = true;
  return "is stored otherwise than the first image (EXIF orientation " + number + " after " +
         std::to_string(*usual_) +
         "), and the pixels of both are used as stored; if the images look alike in a viewer, turn "
         "the files, such as with `exiftran -ai` or `jpegtran`";
}

std::optional<std::string> ImageWarnings::ofBits(std::size_t beyond_bits, int bits) {
  if (beyond_bits == 0 || are_bits_told_) return std::nullopt;
  are_bits_told_ = true;
  return "has " + std::to_string(beyond_bits) + " values of more than " + std::to_string(bits) +
         " bits, which become white (255); set bits to as many as the camera has, or remove it";
}

}  // namespace tolman::image_folders
