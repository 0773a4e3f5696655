// SPDX-License-Identifier: BSD-3-Clause
// Photometric calibration of a camera: for images whose grey levels are not proportional to light,
// or whose corners are dark (Engel, Usenko, Cremers, "A photometrically calibrated benchmark for
// monocular visual odometry", 2016).
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "tolman/image.hpp"

namespace tolman::image_folders {

/// Makes grey levels proportional to the light that reaches the lens: I' = G^-1(I) / V.
class PhotometricCalibration {
 public:
  PhotometricCalibration() = default;  ///< leaves images unchanged
  /// `response`: the inverse response G^-1 as 256 numbers that rise (pcalib.txt). vignette.png
  /// beside it is the attenuation V, of images of this size; its brightest pixel means 1. Throws
  /// DataError.
  PhotometricCalibration(const std::filesystem::path& response, int width, int height);

  bool isNeeded() const { return !light_.empty(); }
  Image apply(const Image& image) const;

 private:
  void readResponse(const std::filesystem::path& file);
  void readVignette(const std::filesystem::path& file, int width, int height);

  std::vector<float> light_;  ///< by grey level, 0 to 255; empty: nothing to do
  std::vector<float> gain_;   ///< 1 / V by pixel; empty: 1 everywhere
};

}  // namespace tolman::image_folders
