// SPDX-License-Identifier: BSD-3-Clause
// What remains of a lens after a calibration that is not quite right: a smooth field of small
// displacements over the image.
#pragma once

#include <cstdint>
#include <vector>

namespace tolman::town {

/// Row-major, one per pixel; empty where the calibration is right.
struct PixelWarp {
  std::vector<float> x;  ///< px: the ray of pixel u is that of u + x in a perfect camera
  std::vector<float> y;

  bool isEmpty() const { return x.empty(); }
};

/// Waves of up to three half periods over the width and two over the height, without a constant;
/// `rms_px` is the root mean square of the displacements' length. Empty for 0.
PixelWarp makeWarp(int width, int height, double rms_px, std::uint32_t seed);

}  // namespace tolman::town
