// SPDX-License-Identifier: BSD-3-Clause
// Position of a corner of one image in another one, to a fraction of a pixel, in both directions.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "pyramid.hpp"

namespace tolman::direct_sparse {

inline constexpr int kLargestPatchRadius = 7;  // px

/// Pixel of `there` that shows what `here` shows at (u, v): Gauss-Newton steps from `start` (Lucas
/// and Kanade 1981; with gradients of the first image, as Baker and Matthews 2004) for a square
/// patch of 2 radius + 1 pixels a side. `gain`: grey levels of `there` over those of `here`; a
/// constant difference is removed. `radius`: at most kLargestPatchRadius. Empty where the patch is
/// no corner, does not fit, or is farther than 1.5 px from `start`.
std::optional<Eigen::Vector2f> matchPatch(const GrayLevel& here, int u, int v,
                                          const GrayLevel& there, const Eigen::Vector2f& start,
                                          float gain, int radius);

}  // namespace tolman::direct_sparse
