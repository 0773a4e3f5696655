// SPDX-License-Identifier: BSD-3-Clause
// Resamples an image whose rows a smooth field displaces by fractions of a pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "disparity_field.hpp"
#include "pyramid.hpp"

namespace tolman::direct_sparse {

class RowShift {
 public:
  /// Displacement down the columns, px, for images of this size.
  void set(const SmoothField& field, int width, int height);
  /// Images are left as they are.
  void setNone() { steps_.clear(); }
  /// image(u, v) becomes image(u, v + field(u, v)), by Catmull-Rom; beyond the first and the last
  /// row the outermost one is repeated.
  void apply(GrayLevel& image);
  /// px, the field as it is applied: constant in blocks, in steps of 1/32 px.
  double at(double u, double v) const;

 private:
  int width_ = 0;
  int height_ = 0;
  int across_ = 0;                   ///< blocks in a row
  std::vector<std::int16_t> steps_;  ///< of 1/32 px, a block each, row by row; empty: none
  std::vector<std::uint8_t> buffer_;
};

}  // namespace tolman::direct_sparse
