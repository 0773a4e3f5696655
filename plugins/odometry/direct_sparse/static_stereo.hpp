// SPDX-License-Identifier: BSD-3-Clause
// Static stereo: the same pixel in the right image, searched along its row (paper, tracking and
// frame management; algorithms: 5.5).
#pragma once

#include <optional>

#include "pyramid.hpp"

namespace tolman::direct_sparse {

inline constexpr int kMostDisparities = 512;

struct StereoSearch {
  int max_disparity = 160;  ///< px, at most kMostDisparities
  float gain = 1;           ///< right = gain * left + offset
  float offset = 0;         ///< grey levels
};

struct StereoMatch {
  float disparity = 0;  ///< px, may be slightly below zero for far points
  float sigma = 0;      ///< px
  float quality = 0;    ///< second best cost over best cost
};

/// Pixels (u, v) must be kStereoBorder away from the edge.
inline constexpr int kStereoBorder = 5;

/// Sums of absolute differences over 8x5 pixels for each disparity, checked from right to left, and
/// refined to a part of a pixel. Empty where the match is weak, ambiguous or one-sided.
std::optional<StereoMatch> matchStereo(const GrayLevel& left, const GrayLevel& right, int u, int v,
                                       const StereoSearch& search);

/// Gain and offset of the right image from the grey statistics of both.
void balanceBrightness(const GrayLevel& left, const GrayLevel& right, StereoSearch& search);

}  // namespace tolman::direct_sparse
