// SPDX-License-Identifier: BSD-3-Clause
// Refines the inverse depth (1/m) of immature points with a frame that is no keyframe (Engel et
// al., PAMI 2018, section 3.2): search along the epipolar line, then a Gaussian update.
#pragma once

#include "photometric_residual.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

struct EpipolarSettings {
  float largest_inverse_depth = 2;  ///< 1/m, for points without depth; chosen, not tuned
  float longest = 60;               ///< px, of a search; Mapper sets it by the size of the image
};

/// `pair` maps the point's host to the frame; its brightness fields are used. Counts failures.
void observeImmature(const PairGeometry& pair, const GrayLevel& image,
                     const EpipolarSettings& settings, ImmaturePoint& point);

}  // namespace tolman::direct_sparse
