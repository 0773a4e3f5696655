// SPDX-License-Identifier: BSD-3-Clause
// Warnings of images that are read, but hardly as they are meant: each cause once per camera.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "image_file.hpp"

namespace tolman::image_folders {

/// Of one camera, whose images are given one after the other.
class ImageWarnings {
 public:
  /// The text after the name of the file, or nothing. The orientation in EXIF data is told of the
  /// first image, and of the first one that is stored otherwise. Pixels are used as they are
  /// stored, because a calibration is of the stored pixels, but viewers turn them.
  std::optional<std::string> ofOrientation(int orientation);
  /// Of the first image with values beyond the parameter `bits`.
  std::optional<std::string> ofBits(std::size_t beyond_bits, int bits);

 private:
  std::optional<int> usual_;  ///< orientation of the first image
  bool is_change_told_ = false;
  bool are_bits_told_ = false;
};

}  // namespace tolman::image_folders
