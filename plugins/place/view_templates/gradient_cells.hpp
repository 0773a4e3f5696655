// SPDX-License-Identifier: BSD-3-Clause
// Histograms of oriented gradients (Dalal and Triggs, CVPR 2005): the strength of edges in eight
// directions for each cell of a view. They change little with light and contrast.
#pragma once

#include <vector>

#include "tolman/image.hpp"

namespace tolman::view_templates {

/// Directions of an edge over 180 degrees: the sign of the gradient is ignored. Chosen, not
/// tuned.
inline constexpr int kDirections = 8;
/// Samples along each side of a cell, from which its gradients are computed. Chosen, not tuned.
inline constexpr int kSamplesPerCell = 8;

/// Part of an image, px.
struct Crop {
  int x0 = 0;
  int y0 = 0;
  int width = 0;
  int height = 0;
};

/// Mean grey in [0, 1] of `columns` x `rows` blocks that fill the crop; their sides are rounded to
/// pixels, so they differ by one. Colour counts as the mean of its channels.
void averageCrop(const Image& image, const Crop& crop, int columns, int rows,
                 std::vector<float>& samples);

/// Computes from (columns x rows) * kSamplesPerCell samples one block of columns x rows cells in
/// [0, 1] for each direction, one after the other. Each cell is normalised by the edges of its
/// neighbourhood of 3x3 cells; with hardly any edges there it is near 0.
void gradientCells(const std::vector<float>& samples, int columns, int rows,
                   std::vector<float>& cells);

}  // namespace tolman::view_templates
