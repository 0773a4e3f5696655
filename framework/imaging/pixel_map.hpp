// SPDX-License-Identifier: BSD-3-Clause
// Makes the rectified image from a raw one: for each pixel the place in the raw image that it is
// interpolated from, computed once.
#pragma once

#include <cstdint>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/image.hpp"

namespace tolman::imaging {

class PixelMap {
 public:
  PixelMap(const RawCamera& raw, const Eigen::Matrix3d& R_rectified_raw,
           const CameraRig& rectified);

  /// Bilinear, in steps of 1/128 px; black where the raw image shows nothing. Parallel in rows: the
  /// same bytes for any number of threads. An image of another size than the map's stays empty.
  Image apply(const Image& raw) const;

  /// Pixels that the raw image does not show.
  std::int64_t blackPixels() const { return black_; }

 private:
  struct Place {
    std::uint16_t x = 0;  ///< the pixel above and left of the place
    std::uint16_t y = 0;
    std::uint8_t right = kNowhere;  ///< share of the pixels to the right, in 1/128
    std::uint8_t below = 0;
  };
  static constexpr std::uint8_t kNowhere = 255;

  template <int Channels>
  void fillRow(const Image& raw, int row, std::uint8_t* out) const;

  int raw_width_;
  int raw_height_;
  int width_;
  int height_;
  std::vector<Place> places_;  ///< row by row
  std::int64_t black_ = 0;
};

}  // namespace tolman::imaging
