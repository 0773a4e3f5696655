// SPDX-License-Identifier: BSD-3-Clause
// A block of cells over three axes that all wrap: the continuous attractors of NeuroSLAM. With one
// layer it is a sheet of two axes.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tolman::neuroslam_cells {

/// A place in the block, in cells, each axis in [0, size).
using CellPlace = std::array<double, 3>;

/// A Gaussian of odd width, its weights adding up to one.
std::vector<float> gaussianKernel(int width, double sigma);

class ActivityTorus {
 public:
  /// Sizes of the axes; no cell is active.
  explicit ActivityTorus(const std::array<int, 3>& sizes);

  const std::array<int, 3>& sizes() const { return sizes_; }
  std::span<const float> values() const { return now_; }  ///< the last axis is the slowest
  float at(const std::array<int, 3>& cell) const { return now_[indexOf(cell)]; }
  /// Adds to the cell nearest to the place.
  void add(const CellPlace& place, float activity);
  float total() const;

  /// One step of the attractor: convolves the activity with `excitation`, subtracts its convolution
  /// with `inhibition` and the constant `global`, sets negative cells to zero, and divides by the
  /// total. A block without activity does not change.
  void attract(std::span<const float> excitation, std::span<const float> inhibition, float global);
  /// Moves all activity by so many cells; fractions are split between two neighbours.
  void shift(const CellPlace& cells);

  /// Population vector along each axis, over the cells at most `radius` from the strongest one.
  CellPlace peak(int radius) const;
  /// Signed shortest distance along an axis from `from` to `to`, in cells.
  double away(std::size_t axis, double from, double to) const;

 private:
  std::size_t indexOf(const std::array<int, 3>& cell) const;
  /// out += weight * the activity of `from`, moved by `cells` along the axis.
  void addShifted(const std::vector<float>& from, std::size_t axis, int cells, float weight,
                  std::vector<float>& out) const;
  std::vector<float> spread(std::span<const float> kernel) const;

  std::array<int, 3> sizes_;
  std::vector<float> now_;
};

}  // namespace tolman::neuroslam_cells
