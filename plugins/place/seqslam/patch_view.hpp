// SPDX-License-Identifier: BSD-3-Clause
// A view: the image reduced to a few thousand grey pixels, each square patch of them brought to
// mean 0 and standard deviation 1.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tolman/image.hpp"

namespace tolman::seqslam {

struct ViewSettings {
  int columns = 64;  ///< px
  int rows = 32;
  int patch = 8;  ///< px, as published
};

/// Pixels are in units of 1 / kUnit standard deviations, row by row, clipped at 127. A pixel of a
/// patch of 8 x 8 is within 8 standard deviations of the mean.
inline constexpr int kUnit = 15;
using PatchView = std::vector<std::int8_t>;

/// Patches at the right and lower edge may be smaller. All zero for an image without any contrast.
PatchView patchView(const Image& image, const ViewSettings& settings);

/// Mean absolute difference of two views of one size, standard deviations.
float differenceOf(std::span<const std::int8_t> a, std::span<const std::int8_t> b);

}  // namespace tolman::seqslam
