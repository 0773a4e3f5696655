// SPDX-License-Identifier: BSD-3-Clause
// Static stereo (Wang et al., ICCV 2017): disparity (px) of a pixel of the left image
// by a search along its row in the right image.
#pragma once

#include <optional>

#include "pyramid.hpp"

namespace tolman::direct_sparse {

inline constexpr int kMaxDisparities = 512;  // px; bounds the time of a row search

struct StereoSearch {
  int max_disparity = 160;  ///< px, at most kMaxDisparities
  float gain = 1;           ///< right = gain * left + offset
  float offset = 0;         ///< grey levels
};

struct StereoMatch {
  float disparity = 0;  ///< px, slightly negative for far points is possible
  float sigma = 0;      ///< px
  float quality = 0;    ///< second best cost over best cost
};

/// Pixels (u, v) must be kStereoBorder away from the edge.
inline constexpr int kStereoBorder = 5;

/// Sums of absolute differences over 8x5 pixels for each disparity, checked from right to left, and
/// refined to sub-pixel accuracy. Empty if the match is weak, ambiguous or fails the check.
std::optional<StereoMatch> matchStereo(const GrayLevel& left, const GrayLevel& right, int u, int v,
                                       const StereoSearch& search);

/// Gain and offset of the right image from the grey statistics of both.
void balanceBrightness(const GrayLevel& left, const GrayLevel& right, StereoSearch& search);

}  // namespace tolman::direct_sparse
