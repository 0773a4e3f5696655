// SPDX-License-Identifier: BSD-3-Clause
// Refines immature points with a frame that is no keyframe: search along the epipolar line and a
// Gaussian update of the inverse depth (paper, frame management; algorithms: 5.6).
#pragma once

#include "keyframe.hpp"
#include "photometric_residual.hpp"

namespace tolman::direct_sparse {

struct EpipolarSettings {
  float largest_inverse_depth = 2;  ///< 1/m, where nothing is known yet
  float longest = 60;               ///< px, of a search
};

/// `pair` maps the point's host to the frame; its brightness fields are used. Counts failures.
void observeImmature(const PairGeometry& pair, const GrayLevel& image,
                     const EpipolarSettings& settings, ImmaturePoint& point);

}  // namespace tolman::direct_sparse
