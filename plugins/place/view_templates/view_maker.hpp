// SPDX-License-Identifier: BSD-3-Clause
// From an image to a view: crop, block average, normalisation (algorithms of OpenRatSLAM).
#pragma once

#include <vector>

#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::view_templates {

/// What the camera sees, as a few hundred numbers in [0, 1]; row-major.
struct View {
  std::vector<float> cells;
  double mean = 0;         ///< of all cells
  int block_width_px = 0;  ///< image columns that one cell averages
};

struct ViewSettings {
  int columns = 60;
  int rows = 10;
  /// The part of the image that is looked at, as fractions of its width and height.
  double crop_x_min = 0;
  double crop_x_max = 1;
  double crop_y_min = 0;
  double crop_y_max = 1;
  double normalisation = 0;      ///< mean that each view is scaled to; 0: off
  int patch_radius = 0;          ///< cells; 0: no patch normalisation
  double patch_minimum_std = 0;  ///< flatter patches become 0.5
};

class ViewMaker {
 public:
  explicit ViewMaker(const ViewSettings& settings) : settings_(settings) {}

  /// Overwrites `view`. InvalidParameter when the crop has fewer pixels than cells.
  Status make(const Image& image, View& view);
  /// The same failure, before there is an image.
  Status checkSize(int image_width, int image_height) const;

 private:
  /// The crop's corner, and the size of the blocks that become cells, px.
  struct Blocks {
    int x0;
    int y0;
    int width;
    int height;
  };
  Result<Blocks> blocksOf(int image_width, int image_height) const;

  ViewSettings settings_;
  std::vector<float> before_patches_;
};

/// Mean grey / 255 of blocks of block_width x block_height pixels from (x0, y0) on; colour counts
/// as the mean of its channels. Fills every one of columns x rows cells.
void averageBlocks(const Image& image, int x0, int y0, int block_width, int block_height,
                   int columns, int rows, std::vector<float>& cells);

/// Scales to the mean `target` and clamps to [0, 1]. A black view stays black.
void normaliseMean(double target, std::vector<float>& cells);

/// v' = clamp(((v - mean) / std + 3) / 6, 0, 1) over windows of (2 radius + 1)^2 cells. A window
/// that reaches over the border repeats the border's cells.
void normalisePatches(int columns, int radius, double minimum_std, const std::vector<float>& source,
                      std::vector<float>& cells);

}  // namespace tolman::view_templates
