// SPDX-License-Identifier: BSD-3-Clause
// Local views of images: blocks of grey with normalisation (as OpenRatSLAM, Ball et al. 2013), or
// edges.
//
// Histograms of oriented gradients (Dalal and Triggs, CVPR 2005): the strength of edges in eight
// directions for each cell of a view. They change little with light and contrast.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "tolman/image.hpp"
#include "tolman/status.hpp"

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

// Computes a local view from an image: crop, then block averages with normalisation (as
// OpenRatSLAM, Ball et al. 2013), or histograms of oriented gradients.

/// What the cells of a view hold.
enum class CellKind : std::uint8_t {
  Grey,       ///< mean grey of a block, as in OpenRatSLAM
  Gradients,  ///< strength of edges, kDirections layers of rows x columns one below the other
};
inline constexpr std::array<std::string_view, 2> kCellKindNames = {"grey", "gradients"};
constexpr std::span<const std::string_view> enumNames(CellKind) { return kCellKindNames; }
constexpr int layersOf(CellKind kind) { return kind == CellKind::Gradients ? kDirections : 1; }

/// A local view: some hundred cells in [0, 1], row-major.
struct LocalView {
  std::vector<float> cells;
  double mean = 0;           ///< of all cells
  double cell_width_px = 0;  ///< image columns per cell
};

struct LocalViewSettings {
  int columns = 60;
  int rows = 10;
  /// The part of the image that is used, as fractions of its width and height.
  double crop_x_min = 0;
  double crop_x_max = 1;
  double crop_y_min = 0;
  double crop_y_max = 1;
  double normalisation = 0;        ///< mean that each view is scaled to; 0: off
  int patch_radius = 0;            ///< cells; 0: no patch normalisation
  CellKind kind = CellKind::Grey;  ///< the normalisations are only for Grey
};

class ViewMaker {
 public:
  explicit ViewMaker(const LocalViewSettings& settings) : settings_(settings) {}

  /// Overwrites `view`. InvalidParameter when the crop has fewer pixels than cells.
  Status make(const Image& image, LocalView& view);
  /// The same check without an image.
  Status checkSize(int image_width, int image_height) const;

 private:
  Result<Crop> cropOf(int image_width, int image_height) const;
  void makeGrey(const Image& image, const Crop& crop, LocalView& view);

  LocalViewSettings settings_;
  std::vector<float> scratch_;
};

/// Mean grey / 255 of blocks of block_width x block_height pixels from (x0, y0) on; colour counts
/// as the mean of its channels. Fills every one of columns x rows cells.
void averageBlocks(const Image& image, int x0, int y0, int block_width, int block_height,
                   int columns, int rows, std::vector<float>& cells);

/// Scales to the mean `target` and clamps to [0, 1]. A black view stays black.
void normaliseMean(double target, std::vector<float>& cells);

/// v' = clamp(((v - mean) / std + 3) / 6, 0, 1) over windows of (2 radius + 1)^2 cells. Outside of
/// the view the cells of the border are repeated. Flat windows become 0.5.
void normalisePatches(int columns, int radius, const std::vector<float>& source,
                      std::vector<float>& cells);

}  // namespace tolman::view_templates
