// SPDX-License-Identifier: BSD-3-Clause
// The costs of a row search: sums of absolute differences of a patch at each pixel of a row.
#pragma once

#include <array>
#include <cstdint>

#include "pyramid.hpp"

namespace tolman::direct_sparse {

/// Size, px; columns -4 ... 3 and rows -2 ... 2 around the pixel. Chosen, not tuned.
inline constexpr int kPatchWidth = 8;
inline constexpr int kPatchHeight = 5;

using StereoPatch = std::array<std::uint8_t, kPatchWidth * kPatchHeight>;

/// Further costs that rowCosts() may write behind the last one; `costs` must have room for them.
inline constexpr int kMoreCosts = 8;

/// The cost of each pixel (u, v) with `u_begin` <= u < `u_end`, beginning with that of `u_begin`.
/// At each of these pixels the patch must lie within the image, and three more rows below it.
void rowCosts(const StereoPatch& patch, const GrayLevel& image, int u_begin, int u_end, int v,
              std::uint16_t* costs);

}  // namespace tolman::direct_sparse
