// SPDX-License-Identifier: BSD-3-Clause
// Makes the rectified image from a raw one. The positions in the raw image from which the pixels
// are interpolated are computed once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/pixel_groups.hpp"
#include "tolman/camera.hpp"
#include "tolman/image.hpp"

namespace tolman::engine {

class PixelMap {
 public:
  enum class Speed : std::uint8_t { Portable, Fastest };

  PixelMap(const RawCamera& raw, const Eigen::Matrix3d& R_rectified_raw, const CameraRig& rectified,
           Speed speed = Speed::Fastest);

  /// Bilinear, in steps of 1/64 px; black where the raw image shows nothing. Rows are computed in
  /// parallel; the bytes are the same for any number of threads and any processor. For a raw image
  /// of another size than the map's the result is empty.
  Image apply(const Image& raw) const;

 private:
  std::span<const RawPosition> positionsOf(int row) const;
  std::size_t firstGroup(int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_ / 8);
  }

  int raw_width_;
  int raw_height_;
  int width_;
  int height_;
  std::vector<RawPosition> positions_;  ///< row by row
  std::vector<PixelGroup> groups_;      ///< the same in groups, or none
};

}  // namespace tolman::engine
