// SPDX-License-Identifier: BSD-3-Clause
// The noise of an image, and a filter for noisy ones. In the dark a camera amplifies noise until it
// has the gradients of weak texture: points are then chosen on noise, their depths are chance, and
// the scale and the shape of a window of a single camera follow them (docs/report/odometry.md).
#pragma once

#include <cstdint>
#include <vector>

#include "pyramid.hpp"

namespace tolman::direct_sparse {

/// Standard deviation of the noise, grey levels, from the differences that a plane of grey values
/// does not have (Immerkaer, CVIU 1996). Their lower quartile is taken, not their mean, because
/// texture makes differences too; images full of fine texture still seem noisier than they are.
/// 0 where all pixels are black or saturated.
float imageNoise(const GrayLevel& image);

/// Share, 0 to 1, of the smoothed image that images of this noise are mixed with.
float smoothedShare(float noise);

/// Mixes the image with its average over 3 x 3 pixels (weights 1 2 1; pixels at the border are
/// repeated). `before` is a buffer.
void smooth(GrayLevel& image, float share, std::vector<std::uint8_t>& before);

}  // namespace tolman::direct_sparse
