// SPDX-License-Identifier: BSD-3-Clause
// Residual distortion of an inexact calibration: a smooth field of small displacements over the
// image.
#pragma once

#include <cstdint>
#include <vector>

namespace tolman::town {

/// Displacements, row-major, one per pixel; empty for an exact calibration.
struct PixelWarp {
  std::vector<float> x;  ///< px: the ray of pixel u is that of u + x in a perfect camera
  std::vector<float> y;

  bool isEmpty() const { return x.empty(); }
};

/// A sum of cosines of up to three half periods over the width and two over the height, with mean
/// 0. `rms_px` is the root mean square of the length of displacements. Empty for 0.
PixelWarp makeWarp(int width, int height, double rms_px, std::uint32_t seed);

}  // namespace tolman::town
