// SPDX-License-Identifier: BSD-3-Clause
// Selects candidate points (Engel et al., PAMI 2018, section 3.2): pixels whose gradient exceeds
// the median of their 32 x 32 block by a margin, evenly distributed.
#pragma once

#include <cstdint>
#include <vector>

#include "pyramid.hpp"

namespace tolman::direct_sparse {

struct Pixel {
  int u = 0;
  int v = 0;
};

/// Keeps the buffers and the adapted cell size from keyframe to keyframe.
class PointSelector {
 public:
  void reset() { cell_ = 0; }
  /// About `wanted` pixels, at least `border` away from the image's edge, in the order of cells.
  const std::vector<Pixel>& select(const GrayLevel& image, int wanted, int border);

 private:
  void measure(const GrayLevel& image);
  void findThresholds();
  void pickFromCells(const GrayLevel& image, int border);
  /// `most`: squared differences that no pixel of the cell exceeds. Returns such a value.
  float pickFromCell(const GrayLevel& image, int u0, int v0, int size, int border, float relax,
                     float most);
  float thresholdAt(int u, int v) const;

  int width_ = 0;
  int height_ = 0;
  int blocks_u_ = 0;
  int blocks_v_ = 0;
  int cell_ = 0;                        ///< px; 0 before the first image
  std::vector<std::uint8_t> strength_;  ///< gradient of each pixel of even rows, grey levels / px
  std::vector<float> raw_;
  std::vector<float> thresholds_;
  std::vector<Pixel> pixels_;
};

}  // namespace tolman::direct_sparse
